#pragma once

#include <vector>

#include "fit/study/study_fit.hpp"
#include "fit/support/checkpoint.hpp"

namespace shadefit {

/// The minimax fit of a study of two or three variables.
///
/// The exchange minimises the largest |weight * error| on a set of places that grows. A linear programme of
/// the errors and their derivatives there (fit/steps/linear_programme.hpp) gives a step, and the tops of
/// the error after the step join the set. The form is linearised at each step, and a step that does not
/// lower the largest error is halved. A form that is linear in its parameters is fitted by
/// `solve_linear_fit`. Source: Remez 1934, "Sur la détermination des polynomes
/// d'approximation de degré donnée"; in several variables the exchange of one finite set for a larger one is
/// that of Blankenship, Falk 1976, "Infinitely constrained optimization problems", Journal of Optimization
/// Theory and Applications 19.
///
/// It starts from the least-squares fit and from other basins; the lowest level counts. `digits` are those of
/// a Newton step in long double on the places that determine the parameters, one more than there are
/// parameters. In several variables fewer tops may be at the level. Then their curvature determines the rest
/// (`curved_level`), or the fit is degenerate or not converged, and `why` has the level. An exchange that
/// runs to infinity also starts beyond it (`beyond_infinity`).
StudyFit solve_minimax_surface(const ReadStudy& study, const std::vector<Held>& starts,
                               const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
