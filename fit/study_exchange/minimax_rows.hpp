#pragma once

#include <vector>

#include "fit/study/solve_study.hpp"

namespace shadefit {

/// The minimax fit of a study of measured rows: the largest |weight * error| of all rows is made least.
///
/// From the least-squares fit, its other basins and `starts`, `RowDescent` goes down, and Newton's method on
/// the rows at the level finishes. The lowest level counts. If the form is linear, it is the least of all.
/// Otherwise no small step lowers it: the rows at the level have multipliers that say so, and, where these
/// rows leave steps, the curvature is positive along them. `digits` are those of a Newton step in long
/// double.
///
/// Often a few rows alone determine the level, and leave some parameters open: those of a single roughness,
/// or two that the form cannot tell apart. Then these rows stay at their level, and the largest error of the
/// others is made least, and so on, until all parameters are determined. Source: the strict approximation of
/// Rice 1962, "Tchebycheff approximation in a compact metric space", Bulletin of the AMS 68; of finite sets,
/// Descloux 1963, "Approximations in L^p and Chebyshev approximations", SIAM Journal 11. `touching` has the
/// rows of all levels.
StudyFit solve_minimax_rows(const ReadStudy& study, const std::vector<Held>& starts,
                            const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
