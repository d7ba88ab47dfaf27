#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "bench/forms/kernels.hpp"
#include "bench/tradeoff/timed_forms.hpp"
#include "fit/scalars/symbolic.hpp"

namespace shadefit::bench {
namespace {

/// A dense grid over the domain of a target, ends included. For a form with few extrema, the largest error is
/// found to a millionth of it.
Places grid_of(const forms::Target& target) {
  constexpr std::size_t count = 16384, codes = 256;
  const Range cosines{target.from, target.to};
  if (target.arguments == forms::Arguments::cosine) return grid_over({cosines}, {count});
  if (target.arguments == forms::Arguments::cosine_and_code)
    return grid_over({cosines, {0, codes - 1}}, {count / codes, codes});
  Places grid(3);
  for (std::size_t i = 0; i < count; ++i) {
    const auto direction = forms::spread_direction(i);
    for (std::size_t axis = 0; axis < 3; ++axis) grid[axis].push_back(static_cast<float>(direction[axis]));
  }
  return grid;
}

template <class Real>
std::vector<Real> values_of(forms::Kernel<Real> kernel, const Places& places,
                            const std::vector<double>& given) {
  std::vector<Real> parameters;
  for (const double x : given) parameters.push_back(static_cast<Real>(x));
  forms::Inputs<Real> in;
  for (const std::vector<float>& axis : places) in.emplace_back(axis.begin(), axis.end());
  return kernel(in, parameters);
}

TimedTarget made_target(const forms::Target& target) {
  const forms::FormEntry& exact = target.forms.front();
  TimedTarget made{.id = std::string(target.id),
                   .title = std::string(target.id) + ": " + std::string(target.text),
                   .places = grid_of(target),
                   .truth = [kernel = forms::kernels_of(exact.id).front().in_double,
                             given = forms::parameters_of(target, exact.constants.front())](
                                const Places& places) { return values_of(kernel, places, given); }};
  for (const std::vector<float>& axis : made.places) {
    const auto [low, high] = std::ranges::minmax(axis);
    made.ranges.push_back({low, high});
  }
  return made;
}

/// The names of the function's arguments: what a form reads for each element.
std::vector<std::string> arguments_of(forms::Arguments arguments) {
  if (arguments == forms::Arguments::normal_to_lights) return {"x", "y", "z"};
  if (arguments == forms::Arguments::cosine_and_code) return {"c", "code"};
  return {"c"};
}

/// Appends a form with an exp2: a row for each set of its constants.
void append(Trade& all, const forms::Target& target, const forms::FormEntry& form,
            const forms::FormKernels& kernels, const std::vector<double>& truth) {
  for (const forms::Constants& constants : form.constants) {
    TimedForm row{.target = std::string(target.id),
                  .form = std::string(form.id),
                  .constants = constants.id,
                  .label = std::string(form.id),
                  .exp2_degree = kernels.exp2_degree,
                  .function = function_of(target, form, constants)};
    if (constants.id != "none") row.label += ", " + constants.id;
    if (row.exp2_degree > 0) row.label += ", exp2 of degree " + std::to_string(row.exp2_degree);
    row.max_abs_error = largest_error(
        values_of(kernels.in_float, all.targets.back().places, forms::parameters_of(target, constants)),
        truth);
    row.shape = full_id(row);
    all.forms.push_back(std::move(row));
  }
}

}  // namespace

double largest_error(std::span<const float> values, std::span<const double> truth) {
  double largest = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const double error = std::abs(static_cast<double>(values[i]) - truth[i]);
    if (std::isnan(error)) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, error);
  }
  return largest;
}

bool is_of_several_lights(const forms::Target& target) {
  constexpr std::size_t of_one_light = 4;  // its exponent and its direction
  return target.arguments == forms::Arguments::normal_to_lights && target.parameters.size() > of_one_light;
}

ShaderFunction function_of(const forms::Target& target, const forms::FormEntry& form,
                           const forms::Constants& constants) {
  std::vector<Symbolic> numbers;
  for (const auto* list : {&target.parameters, &constants.numbers}) {
    for (const forms::NamedNumber& number : *list) numbers.push_back(Symbolic::number(number.printed));
  }
  const std::vector<std::string> arguments = arguments_of(target.arguments);
  forms::Inputs<Symbolic> one;
  for (const std::string& name : arguments) one.push_back({Symbolic::variable(name)});
  return {form_name, arguments, forms::kernels_of(form.id).front().in_symbols(one, numbers).front()};
}

Trade catalogue_forms(const std::vector<forms::Target>& catalogue, const std::vector<std::string>& targets,
                      Exp2Kinds exp2) {
  Trade all;
  for (const forms::Target& target : catalogue) {
    const bool is_wanted = targets.empty() || std::ranges::find(targets, target.id) != targets.end();
    if (!is_wanted || is_of_several_lights(target)) continue;
    all.targets.push_back(made_target(target));
    const std::vector<double> truth = all.targets.back().truth(all.targets.back().places);
    for (const forms::FormEntry& form : target.forms) {
      for (const forms::FormKernels& kernels : forms::kernels_of(form.id)) {
        if (exp2 == Exp2Kinds::polynomials || kernels.exp2_degree == 0)
          append(all, target, form, kernels, truth);
      }
    }
  }
  return all;
}

ShaderFunction multiply_add_chain() {
  // The highest coefficient, and four that come again and again: exact in half, and 1 in sum.
  const auto part = [](int n) { return integer<Symbolic>(n) / integer<Symbolic>(64); };
  const std::array again{part(1), part(2), part(3), part(6)};
  const Symbolic c = Symbolic::variable("c");
  Symbolic value = part(16);
  for (int i = 0; i < multiply_adds_of_chain; ++i) value = value * c + again[static_cast<std::size_t>(i % 4)];
  return {form_name, {"c"}, value};
}

}  // namespace shadefit::bench
