#pragma once

#include <optional>
#include <vector>

#include "fit/study/study_fit.hpp"
#include "fit/study/study_nodes.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/study_exchange/surface_programme.hpp"

namespace shadefit {

/// Places of a surface whose errors no parameters lower together: the least level.
struct LevelSupport {
  std::vector<std::vector<double>> places;
  std::vector<double> signs;        ///< of the errors there
  std::vector<double> multipliers;  ///< >= 0; they sum to 1, and cancel the derivatives of the errors
};

/// A study whose form is linear in its parameters, and whose error is the form of `weighted`.
struct LinearSurface {
  const ReadStudy& study;
  const ReadStudy& weighted;
  const StudyError& error;
  const std::vector<std::vector<StudyEdge>>& edges;
};

/// Of all parameters with the least level, those with the least mean square of the error.
///
/// Where fewer places hold the level than determine the parameters, many parameters have it. They are a
/// convex set, so one of them has the least mean square. The errors at the places of the support are at the
/// level for all of them. Where such a place is at an end of the range, the error falls from there, or is
/// level: that is a condition on its slope. Each top of the error that exceeds the level becomes one more
/// condition. A quadratic programme (`least_step`) finds which of them touch, and the equations of Karush,
/// Kuhn and Tucker in long double give the digits.
///
/// `start` is the least-squares fit. Empty if the conditions do not settle.
std::optional<StudyFit> least_at_level(const LinearSurface& surface, const LevelSupport& support,
                                       const std::vector<double>& start, const TopsOfError& tops);

}  // namespace shadefit
