#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/device/form_functions.hpp"
#include "bench/device/times/device_forms.hpp"
#include "bench/studies/measure_study.hpp"
#include "fit/scalars/integral.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/support/user_error.hpp"
#include "reports/code/shader_code.hpp"

namespace shadefit::device {
namespace {

/// The floats of a grid over the ranges with their ends, about as many as the catalogue's grid has.
Places grid_over(const std::vector<Range>& ranges) {
  constexpr double most = 16384;
  const auto steps = static_cast<std::size_t>(std::pow(most, 1 / static_cast<double>(ranges.size())) + 0.5);
  std::size_t count = 1;
  for (std::size_t a = 0; a < ranges.size(); ++a) count *= steps;
  Places places(ranges.size());
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t rest = i;
    for (std::size_t a = 0; a < ranges.size(); ++a, rest /= steps) {
      const double share = static_cast<double>(rest % steps) / static_cast<double>(steps - 1);
      places[a].push_back(static_cast<float>(ranges[a].from + share * (ranges[a].to - ranges[a].from)));
    }
  }
  return places;
}

std::function<std::vector<double>(const Places&)> in_double(const Symbolic& formula,
                                                            const std::vector<std::string>& variables) {
  return [=](const Places& places) {
    std::vector<double> values;
    for (std::size_t i = 0; i < places.front().size(); ++i) {
      values.push_back(evaluate<double>(formula, [&](const std::string& name) -> double {
        const auto found = std::find(variables.begin(), variables.end(), name);
        return places.at(static_cast<std::size_t>(found - variables.begin())).at(i);
      }));
    }
    return values;
  };
}

/// Whether GLSL has the functions of a formula. An integral has no code at all.
bool has_code(const ShaderFunction& function) {
  if (integral_depth(function.result) > 0) return false;
  try {
    timing_shader(function, {}, ShaderPrecision::float32, Chain::dependent);
    return true;
  } catch (const UserError&) {
    return false;
  }
}

void require_names(const std::vector<std::string>& variables) {
  for (const std::string& name : variables) {
    const auto reason = reason_to_refuse_name(name, Language::glsl);
    if (!reason.empty())
      throw UserError(fmt::format("--device: GLSL cannot have the variable '{}': {}", name, reason));
  }
}

void append(DeviceForms& all, const StudyComparison& comparison, const bench::TimedTarget& heading) {
  require_names(comparison.variables);
  const ReadStudy read = formulas_of(comparison, comparison.contenders.front());
  DeviceTarget target{heading, {}, {}, {}};
  for (const StudyAxis& axis : read.axes) target.ranges.push_back({axis.lower, axis.upper});
  const std::size_t place = all.targets.size();
  const bool is_formula = comparison.study.rows == nullptr;
  if (is_formula) {
    target.places = grid_over(target.ranges);
    target.truth = in_double(read.target, comparison.variables);
    const ShaderFunction itself{form_name, comparison.variables, read.target};
    if (has_code(itself)) all.forms.push_back({place, row_of(comparison, heading), "target", itself});
  }
  all.targets.push_back(std::move(target));
  std::vector<DeviceForm> added;
  for (const StudyContender& contender : comparison.contenders) {
    const ShaderFunction function{form_name, comparison.variables, contender.code};
    if (!has_code(function))
      throw UserError(fmt::format("--device has no code for the form '{}'", contender.formula));
    bench::TimedForm row = row_of(contender, heading);
    if (!is_formula)
      row.max_abs_error = largest_error(formulas_of(comparison, contender), contender.values).magnitude;
    added.push_back({place, row, contender.form + ": " + to_text(contender.operations), function});
  }
  std::ranges::stable_sort(added, {}, &DeviceForm::shape);
  all.forms.insert(all.forms.end(), added.begin(), added.end());
}

}  // namespace

DeviceForms study_forms(const std::string& id, const std::vector<StudyComparison>& comparisons) {
  DeviceForms all;
  for (const StudyComparison& comparison : comparisons)
    append(all, comparison, bench::timed_target(id, comparisons, comparison));
  return all;
}

}  // namespace shadefit::device
