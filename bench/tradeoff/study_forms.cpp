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

TimedForm row_of(const StudyContender& contender) {
  const std::string& origin = contender.origin.unescaped();
  TimedForm row;
  row.form = contender.form;
  row.constants = origin;
  // "linear, minimax" for a fit, "cubic, Unity Technologies" for a published set.
  row.label =
      contender.form + ", " + (contender.published == nullptr ? origin : origin.substr(0, origin.find(',')));
  return row;
}

void append(FormsToTime& all, const StudyComparison& comparison, TimedTarget heading, Language language) {
  require_names(comparison.variables);
  const ReadStudy read = formulas_of(comparison, comparison.contenders.front());
  FormTarget target{std::move(heading), {}, {}, {}};
  for (const StudyAxis& axis : read.axes) target.ranges.push_back({axis.lower, axis.upper});
  std::vector<FormToTime> added;
  const std::size_t place = all.targets.size();
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
    const ShaderFunction itself{form_name, comparison.variables, read.target};
    const TimedForm row{.form = "target", .label = "the target: " + comparison.study.target};
    if (has_code(itself, language)) all.forms.push_back({place, row, "target", itself});
  }
  for (const StudyContender& contender : comparison.contenders) {
    const ShaderFunction function{form_name, comparison.variables, contender.code};
    if (!has_code(function, language))
      throw UserError(fmt::format("bench has no code in {} for the form '{}'", shadefit::name(language),
                                  contender.formula));
    TimedForm row = row_of(contender);
    row.max_abs_error =
        shadefit::largest_error(formulas_of(comparison, contender), contender.values).magnitude;
    added.push_back({place, row, contender.form + ": " + to_text(contender.operations), function});
  }
  std::ranges::stable_sort(added, {}, &FormToTime::shape);
  all.forms.insert(all.forms.end(), added.begin(), added.end());
  for (FormToTime& form : all.forms) {
    if (form.target == place) form.row.target = target.heading.id;
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

FormsToTime study_forms(const std::string& id, const std::vector<StudyComparison>& comparisons,
                        Language language) {
  FormsToTime all;
  all.are_of_a_study = true;
  for (const StudyComparison& comparison : comparisons) {
    if (comparison.contenders.empty())
      throw UserError("no fit of '" + id +
                      "' converged, and nothing was published: there is nothing to time");
    const std::string number = comparisons.size() == 1 ? "" : fmt::format("-{}", all.targets.size() + 1);
    append(all, comparison, {id + number, for_terminal(target_of(comparison))}, language);
  }
  return all;
}

}  // namespace shadefit::bench
