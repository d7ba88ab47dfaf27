#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bench/tradeoff/timed_forms.hpp"
#include "fit/formula/batch.hpp"
#include "fit/scalars/integral.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/escape.hpp"
#include "reports/studies/study_comparison.hpp"

namespace shadefit::bench {
namespace {

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
