#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/quadrature/metric.hpp"
#include "fit/study/study.hpp"
#include "fit/study/study_fit.hpp"
#include "fit/support/checkpoint.hpp"

/// The fit of a study under an objective, whatever its norm, its bounds and its constraints.
namespace shadefit {

/// What a fit of a study minimises.
struct StudyObjective {
  std::string words = {};  ///< "least squares", "minimax, relative error", "least squares with a = 1.57"
  Study study;
  Norm norm = Norm::least_squares;
  Constraints constraints = {};
  std::optional<std::string> recompute = {};  ///< the formula that gave the values of the rows, if known
  /// `cuts_of_target`, if somebody has looked for them.
  std::optional<std::vector<double>> target_cuts = {};
};

/// The cuts of the only variable of a study at features of its target, weight, density and form. Many fits
/// may share them. Empty if enclosures do not explain them all, and for a study that has cuts or a peak.
std::optional<std::vector<double>> cuts_of_target(const Study& study);

/// The study with the cuts of its variable, for fits under many objectives. The error of such a fit is not
/// looked at again.
Study with_cuts(Study study);

/// The fit under an objective; its errors, where all parameters are held. It starts where the study knows
/// where, and searches the basins else. Throws UserError like `read_study`, `solve_study` and
/// `solve_minimax_study`.
StudyFit fit_study(const StudyObjective& objective, const Checkpoint& checkpoint = keep_going);

/// The same where somebody has read the study of the objective.
StudyFit fit_study(const StudyObjective& objective, ReadStudy read,
                   const Checkpoint& checkpoint = keep_going);

/// The same for its constants, digits and rms error: a fit from known starts has no largest error yet.
StudyFit fit_constants(const StudyObjective& objective, const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
