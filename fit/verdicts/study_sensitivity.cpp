#include "fit/verdicts/study_sensitivity.hpp"

#include <limits>

#include "fit/squares/rules.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

void require_plain(const StudyObjective& objective) {
  if (objective.study.rows)
    throw UserError("--sensitivity does not go with --table: a fit of rows has profile intervals instead");
  if (objective.constraints != Constraints{})
    throw UserError("--sensitivity does not go with a constraint: rounded constants do not meet it");
  if (!objective.study.bounds.empty())
    throw UserError("--sensitivity does not go with --bounds: rounded constants do not keep to them");
}

FittedConstants constants_of(const StudyObjective& asked, const StudyFit& fit, const Checkpoint& checkpoint) {
  const ReadStudy study = read_study(asked.study);
  FittedConstants constants{fit.names, fit.parameters, std::vector<bool>(fit.names.size(), false), {}, {}};
  if (asked.norm == Norm::minimax) {
    constants.objective = [study](const std::vector<double>& parameters) {
      return largest_weighted_error(study, parameters).magnitude;
    };
  } else {
    constants.objective = [study, error = StudyError(study)](const std::vector<double>& parameters) {
      return rms_error(study, error, parameters);
    };
  }
  constants.profile = [asked, names = fit.names, objective = constants.objective, checkpoint](std::size_t i,
                                                                                              double value) {
    if (names.size() == 1) return objective({value});
    const StudyFit again = fit_study(holding(asked, names[i], value), checkpoint);
    // If the held constant alone causes the largest error, the others are free: any of them is the best.
    const bool is_answer = again.status == Status::converged ||
                           (asked.norm == Norm::minimax && again.status == Status::degenerate);
    if (!is_answer) return std::numeric_limits<double>::quiet_NaN();
    std::vector<double> all = again.parameters;
    all.insert(all.begin() + static_cast<std::ptrdiff_t>(i), value);
    return objective(all);
  };
  return constants;
}

/// The objectives that differ in the density or in the range.
std::vector<StudyObjective> others_of(const StudyObjective& asked) {
  std::vector<StudyObjective> others;
  const StudyAxis axis = read_study(asked.study).axes.front();
  if (asked.norm == Norm::least_squares && 0 <= axis.lower && axis.upper <= 1) {
    for (const char* word : {"angle", "cosine-weighted"}) {
      StudyObjective other = asked;
      other.study.over.front().density = density_of(word, axis.variable);
      other.words += std::string(", measure ") + word;
      others.push_back(other);
    }
  }
  const double tenth = (axis.upper - axis.lower) / 10;
  for (const auto& [lower, upper] : {std::pair{axis.lower + tenth, axis.upper},
                                     {axis.lower, axis.upper - tenth},
                                     {axis.lower + tenth, axis.upper - tenth}}) {
    StudyObjective other = asked;
    other.study.over.front().lower = to_text(lower);
    other.study.over.front().upper = to_text(upper);
    other.words += ", " + axis.variable + " in " + to_text(lower) + ":" + to_text(upper);
    others.push_back(other);
  }
  return others;
}

}  // namespace

StudySensitivity sensitivity_of(const StudyObjective& objective, const StudyFit& fit,
                                const Checkpoint& checkpoint) {
  require_plain(objective);
  StudySensitivity result{sensitivity_of(constants_of(objective, fit, checkpoint), checkpoint)};
  if (objective.study.over.size() > 1) return result;
  result.others.push_back({objective.words, fit});
  for (const StudyObjective& other : others_of(objective)) {
    checkpoint();
    result.others.push_back({other.words, fit_study(other, checkpoint)});
  }
  return result;
}

}  // namespace shadefit
