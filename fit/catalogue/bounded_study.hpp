#pragma once

#include <vector>

#include "fit/quadrature/metric.hpp"
#include "fit/squares/solve_in_units.hpp"

namespace shadefit {

/// The best fit whose parameters lie within the bounds of a study. `solve` fits a study under the norm and
/// the constraints; it need not know bounds, but its search may start inside them.
///
/// The answer is the best fit of one face of the box: of the study with some parameters held at bounds. The
/// faces are visited by branch and bound. Without its bounds a face has a fit that is at least as good as any
/// in the face, so that a face with a worse one than the best so far is left out. If that fit lies outside
/// the box, some of its parameters are held at the bounds that they violate, one after the other.
///
/// This is exact for a form that is linear in its parameters, under both norms and with constraints. Proof:
/// on the way from the answer to the fit without bounds both the level and the square do not rise, and they
/// are not both the same. So the way leaves the box at once, and a parameter that it violates is at that
/// bound already. Of another form the search may miss a basin. There all parameters with bounds, of at most
/// six, are held in turn, and each face also has the best fit of the basins inside the box.
///
/// The fit without any bounds is returned if it is degenerate. If a fit in the box is better than the others
/// but did not converge, or other parameters have its level, it is returned with its status. `infeasible` if
/// no face has a fit. Throws what `solve` throws for the study without bounds.
StudyFit solve_bounded_study(const ReadStudy& study, Norm norm, const Constraints& constraints,
                             const std::vector<Held>& starts, const SolveStudy& solve);

}  // namespace shadefit
