#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "bench/forms/kernels.hpp"
#include "bench/tradeoff/timed_forms.hpp"
#include "fit/scalars/symbolic.hpp"

namespace shadefit::bench {
namespace {

/// Places of a grid. For a form with few extrema, the largest error is found to a millionth of it.
constexpr std::size_t grid_places = 16384;

/// A dense grid over the domain of a target, ends included.
Places grid_of(const forms::Target& target) {
  const bool has_normals = target.arguments == forms::Arguments::normal_to_lights;
  const bool has_codes = target.arguments == forms::Arguments::cosine_and_code;
  Places grid(has_normals ? 3 : has_codes ? 2 : 1);
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

template <class Real>
std::vector<Real> values_of(forms::Kernel<Real> kernel, const Places& places,
                            const std::vector<double>& given) {
  const std::size_t size = places.front().size();
  std::vector<Real> parameters, in[3], out(size);
  for (const double x : given) parameters.push_back(static_cast<Real>(x));
  for (std::size_t i = 0; i < places.size(); ++i) in[i].assign(places[i].begin(), places[i].end());
  kernel({{in[0].data(), in[1].data(), in[2].data()}, out.data(), size}, parameters);
  return out;
}

FormTarget made_target(const forms::Catalogue& catalogue, const forms::Target& target) {
  const forms::FormEntry& exact = forms::reference_of(catalogue, target.id);
  FormTarget made{{std::string(target.id), std::string(target.id) + ": " + std::string(target.text)},
                  {},
                  grid_of(target),
                  [kernel = forms::find_kernels(exact.id)->in_double,
                   given = forms::parameters_of(target, exact.constants.front())](const Places& places) {
                    return values_of(kernel, places, given);
                  }};
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

template <class Form>
Symbolic result_of(const std::vector<Symbolic>& numbers) {
  std::array<Symbolic, Form::parameters> p = [&]<std::size_t... I>(std::index_sequence<I...>) {
    return std::array<Symbolic, Form::parameters>{numbers.at(I)...};
  }
  (std::make_index_sequence<Form::parameters>());
  const auto prepared = Form::template prepared<Symbolic>(p);
  const auto variable = [](const char* name) { return Symbolic::variable(name); };
  if constexpr (Form::arguments == forms::Arguments::cosine) {
    return Form()(variable("c"), prepared);
  } else if constexpr (Form::arguments == forms::Arguments::cosine_and_code) {
    return Form()(variable("c"), variable("code"), prepared);
  } else {
    return Form()(std::array<Symbolic, 3>{variable("x"), variable("y"), variable("z")}, prepared);
  }
}

template <class... Forms>
Symbolic result_of(forms::FormList<Forms...>, std::string_view id, const std::vector<Symbolic>& numbers) {
  std::optional<Symbolic> result;
  ((Forms::id == id ? void(result = result_of<Forms>(numbers)) : void()), ...);
  return result.value();
}

/// Appends a form with an exp2: a row for each set of its constants.
void append(FormsToTime& all, const forms::Target& target, const forms::FormEntry& form,
            const forms::FormKernels& kernels, const std::vector<double>& truth) {
  for (const forms::Constants& constants : form.constants) {
    TimedForm row{.target = std::string(target.id),
                  .form = std::string(form.id),
                  .constants = constants.id,
                  .label = std::string(form.id),
                  .exp2_degree = kernels.exp2_degree};
    if (constants.id != "none") row.label += ", " + constants.id;
    if (row.exp2_degree > 0) row.label += ", exp2 of degree " + std::to_string(row.exp2_degree);
    row.max_abs_error = largest_error(
        values_of(kernels.in_float, all.targets.back().places, forms::parameters_of(target, constants)),
        truth);
    const std::string shape = full_id(row);
    all.forms.push_back(
        {all.targets.size() - 1, std::move(row), shape, function_of(target, form, constants)});
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
  return {form_name, arguments_of(form.arguments), result_of(forms::AllForms(), form.id, numbers)};
}

FormsToTime catalogue_forms(const forms::Catalogue& catalogue, const std::vector<std::string>& targets,
                            Exp2Kinds exp2) {
  FormsToTime all;
  for (const forms::Target& target : catalogue.targets) {
    const bool is_wanted = targets.empty() || std::ranges::find(targets, target.id) != targets.end();
    if (!is_wanted || is_of_several_lights(target)) continue;
    all.targets.push_back(made_target(catalogue, target));
    const std::vector<double> truth = all.targets.back().truth(all.targets.back().places);
    for (const forms::FormEntry& form : catalogue.forms) {
      if (form.target != target.id) continue;
      for (const forms::FormKernels& kernels : forms::all_kernels()) {
        const bool has_its_exp2 = exp2 == Exp2Kinds::polynomials || kernels.exp2_degree == 0;
        if (kernels.form == form.id && has_its_exp2) append(all, target, form, kernels, truth);
      }
    }
  }
  return all;
}

ShaderFunction multiply_add_chain() {
  using Form = forms::MultiplyAdds;
  return {form_name, {"c"}, Form()(Symbolic::variable("c"), Form::prepared(std::array<Symbolic, 0>()))};
}

}  // namespace shadefit::bench
