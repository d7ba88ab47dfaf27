#include "bench/tradeoff/grid_errors.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace shadefit::bench {
namespace {

/// Places of a grid: a multiple of 64. For a form with few extrema, the largest error is found to a millionth
/// of it.
constexpr std::size_t grid_places = 16384;

template <class Real>
std::vector<Real> values_of(forms::Kernel<Real> kernel, const Grid& grid, forms::Arguments arguments,
                            const std::vector<double>& given) {
  std::vector<Real> parameters, in[3], out(grid_places);
  for (const double x : given) parameters.push_back(static_cast<Real>(x));
  for (std::size_t i = 0; i < grid.size(); ++i) in[i].assign(grid[i].begin(), grid[i].end());
  std::vector<std::uint8_t> codes;
  if (arguments == forms::Arguments::cosine_and_code) {
    for (const float code : grid.back()) codes.push_back(static_cast<std::uint8_t>(code));
  }
  kernel({{in[0].data(), in[1].data(), in[2].data()}, codes.data(), out.data(), grid_places}, parameters);
  return out;
}

template <class Real>
double largest_error(const std::vector<Real>& values, const std::vector<double>& truth) {
  double largest = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    largest = std::max(largest, std::abs(static_cast<double>(values[i]) - truth[i]));
  return largest;
}

}  // namespace

Grid grid_of(const forms::Target& target) {
  const bool has_normals = target.arguments == forms::Arguments::normal_to_lights;
  const bool has_codes = target.arguments == forms::Arguments::cosine_and_code;
  Grid grid(has_normals ? 3 : has_codes ? 2 : 1);
  for (std::size_t i = 0; i < grid_places; ++i) {
    if (has_normals) {
      const auto direction = forms::spread_direction(i);
      for (std::size_t axis = 0; axis < 3; ++axis) grid[axis].push_back(static_cast<float>(direction[axis]));
      continue;
    }
    // With codes: each of the 256 at every 64th of the cosines.
    const std::size_t step = has_codes ? i / 256 : i,
                      last = has_codes ? grid_places / 256 - 1 : grid_places - 1;
    const double share = static_cast<double>(step) / static_cast<double>(last);
    grid[0].push_back(static_cast<float>(target.from + share * (target.to - target.from)));
    if (has_codes) grid[1].push_back(static_cast<float>(i % 256));
  }
  return grid;
}

std::vector<double> truth_at(const Grid& grid, const forms::Catalogue& catalogue,
                             const forms::Target& target) {
  const forms::FormEntry& exact = forms::reference_of(catalogue, target.id);
  const auto scalar = forms::compiled_forms(forms::Width::scalar);
  return values_of(std::ranges::find(scalar, exact.id, &forms::CompiledForm::form)->in_double, grid,
                   target.arguments, forms::parameters_of(target, exact.constants.front()));
}

std::vector<FormError> grid_errors(const forms::Catalogue& catalogue, const std::vector<std::string>& targets,
                                   const std::function<void()>& between) {
  std::vector<FormError> errors;
  const forms::Target* target = nullptr;
  Grid grid;
  std::vector<double> truth;
  for (const forms::FormEntry& form : catalogue.forms) {
    if (!forms::is_wanted(targets, form.target)) continue;
    if (target == nullptr || target->id != form.target) {
      target = &forms::target_of(catalogue, form.target);
      grid = grid_of(*target);
      truth = truth_at(grid, catalogue, *target);
    }
    for (const forms::CompiledForm& version : forms::compiled_forms(forms::Width::sse2)) {
      if (version.form != form.id) continue;
      for (const forms::Constants& constants : form.constants) {
        between();
        const auto given = forms::parameters_of(*target, constants);
        FormError error{std::string(form.target), std::string(form.id), constants.id, version.exp2_degree};
        error.max_abs_error = largest_error(values_of(version.in_float, grid, form.arguments, given), truth);
        errors.push_back(error);
        if (version.in_double == nullptr) continue;
        error.is_double = true;
        error.max_abs_error = largest_error(values_of(version.in_double, grid, form.arguments, given), truth);
        errors.push_back(error);
      }
    }
  }
  return errors;
}

}  // namespace shadefit::bench
