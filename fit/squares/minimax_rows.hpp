#pragma once

#include <vector>

#include "fit/study/study_fit.hpp"
#include "fit/support/checkpoint.hpp"

namespace shadefit {

/// The minimax fit of a study of measured rows: it minimises the largest |weight * error| of all rows.
///
/// `RowDescent` goes down from the least-squares fit, from its other basins and from `starts`. Newton's
/// method on the rows at the level finishes, and the lowest level counts. If the form is linear, it is the
/// global minimum. Otherwise no small step lowers it: the multipliers of the rows at the level say so, and
/// the curvature is positive along the steps that these rows leave open. `digits` are those of a Newton step
/// in long double.
///
/// Often a few rows alone determine the level and leave some parameters open: the rows of a single roughness,
/// or two rows that the form cannot tell apart. Then these rows stay at their level, and the largest error of
/// the others is minimised, and so on until all parameters are determined. Source: the strict approximation
/// of Rice 1962, "Tchebycheff approximation in a compact metric space", Bulletin of the AMS 68; of finite
/// sets, Descloux 1963, "Approximations in L^p and Chebyshev approximations", SIAM Journal 11. `touching` has
/// the rows of all levels.
StudyFit solve_minimax_rows(const ReadStudy& study, const std::vector<Held>& starts,
                            const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
