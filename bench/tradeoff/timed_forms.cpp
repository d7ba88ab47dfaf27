#include "bench/tradeoff/timed_forms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "bench/forms/kernels.hpp"
#include "fit/formula/batch.hpp"
#include "fit/scalars/integral.hpp"
#include "fit/scalars/symbolic.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/escape.hpp"
#include "reports/studies/study_comparison.hpp"

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

/// Whether a language has the functions of a formula. An integral has no code at all.
bool has_code(const ShaderFunction& function, Language language) {
  if (integral_depth(function.result) > 0) return false;
  try {
    shader_code(std::span(&function, 1), language, ShaderPrecision::float32, {});
    return true;
  } catch (const UserError&) {
    return false;
  }
}

void require_names(const std::vector<std::string>& variables) {
  for (const std::string& name : variables) {
    const auto reason = reason_to_refuse_name(name);
    if (!reason.empty()) throw UserError(fmt::format("code cannot have the variable '{}': {}", name, reason));
  }
}

TimedForm form_of(const StudyComparison& comparison, const StudyContender& contender) {
  const std::string& origin = contender.origin.unescaped();
  // "linear, minimax" for a fit, "cubic, Unity Technologies" for a published set.
  const std::string by = contender.published == nullptr ? origin : origin.substr(0, origin.find(','));
  return {.form = contender.form,
          .constants = origin,
          .label = contender.form + ", " + by,
          .max_abs_error =
              shadefit::largest_error(formulas_of(comparison, contender), contender.values).magnitude,
          .function = {form_name, comparison.variables, contender.code},
          .shape = contender.form + ": " + to_text(contender.operations)};
}

void append(Trade& all, const StudyComparison& comparison, TimedTarget target, Language language) {
  require_names(comparison.variables);
  const ReadStudy read = formulas_of(comparison, comparison.contenders.front());
  for (const StudyAxis& axis : read.axes) target.ranges.push_back({axis.lower, axis.upper});
  std::vector<TimedForm> forms;
  for (const StudyContender& contender : comparison.contenders) {
    forms.push_back(form_of(comparison, contender));
    if (!has_code(forms.back().function, language))
      throw UserError(fmt::format("bench has no code in {} for the form '{}'", shadefit::name(language),
                                  contender.formula));
  }
  std::ranges::stable_sort(forms, {}, &TimedForm::shape);
  if (comparison.study.rows == nullptr) {
    // About as many as the catalogue's grid has.
    const double steps = std::pow(16384, 1 / static_cast<double>(target.ranges.size())) + 0.5;
    target.places =
        grid_over(target.ranges, std::vector(target.ranges.size(), static_cast<std::size_t>(steps)));
    target.truth = [tape = tape_of(read.target, comparison.variables)](const Places& places) {
      std::vector<std::vector<double>> coordinates;
      for (const std::vector<float>& axis : places) coordinates.emplace_back(axis.begin(), axis.end());
      return values_at(tape, coordinates, {});
    };
    const TimedForm itself{.form = "target",
                           .label = "the target: " + comparison.study.target,
                           .function = {form_name, comparison.variables, read.target},
                           .shape = "target"};
    if (has_code(itself.function, language)) forms.insert(forms.begin(), itself);
  }
  for (TimedForm& form : forms) {
    form.target = target.id;
    all.forms.push_back(std::move(form));
  }
  all.targets.push_back(std::move(target));
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

Places grid_over(const std::vector<Range>& ranges, const std::vector<std::size_t>& steps) {
  std::size_t count = 1;
  for (const std::size_t in_axis : steps) count *= in_axis;
  Places places(ranges.size());
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t rest = i;
    for (std::size_t a = 0; a < ranges.size(); rest /= steps[a++]) {
      const double share = static_cast<double>(rest % steps[a]) / static_cast<double>(steps[a] - 1);
      places[a].push_back(static_cast<float>(ranges[a].from + share * (ranges[a].to - ranges[a].from)));
    }
  }
  return places;
}

Trade study_forms(const std::string& id, const std::vector<StudyComparison>& comparisons, Language language) {
  Trade all{.shows_all_sets = true};
  for (const StudyComparison& comparison : comparisons) {
    if (comparison.contenders.empty())
      throw UserError("no fit of '" + id +
                      "' converged, and nothing was published: there is nothing to time");
    const std::string number = comparisons.size() == 1 ? "" : fmt::format("-{}", all.targets.size() + 1);
    append(all, comparison, {id + number, for_terminal(shadefit::target_of(comparison))}, language);
  }
  return all;
}

}  // namespace shadefit::bench
