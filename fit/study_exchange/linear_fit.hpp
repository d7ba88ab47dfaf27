#pragma once

#include <vector>

#include "fit/quadrature/metric.hpp"
#include "fit/study/search.hpp"
#include "fit/study/study_fit.hpp"
#include "fit/support/checkpoint.hpp"

namespace shadefit {

/// Whether the slopes of the error by the parameters depend on each other, where the form is linear in them:
/// then some parameters change together and the curve stays the same.
bool are_dependent(const SampledStudy<double>& sampled, const std::vector<double>& parameters);

/// Whether parameters of such a form satisfy constraints, up to a small share of the error at `start`.
bool keeps_constraints(const ReadStudy& study, const StudyError& error, const Constraints& constraints,
                       const std::vector<std::vector<StudyEdge>>& edges, const SampledStudy<double>& sampled,
                       const std::vector<double>& start, const std::vector<double>& parameters);

/// The fit of a form that is linear in its parameters, under either norm and any constraints.
///
/// The problem is convex. Its conditions, that a curve (fit/study_exchange/linear_curves.hpp) is below its
/// bound at each place, are linear. A programme solves it at places so far, and the tops of the curves that
/// exceed their bounds join the set, until there are none: a cutting plane method. The level of the linear
/// programme is a lower bound for all parameters, by duality, and it rises to the least level.
///
/// Newton's method on the equations of Karush, Kuhn and Tucker in long double gives the digits. The places
/// move with the parameters to the tops of their curves, so that fewer than n + 1 places can determine n
/// parameters. Where these do not, many parameters have the least level. Of them those with the least mean
/// square are the answer: each has the same error at the places of the level, and the error is stationary
/// there. A quadratic programme on a growing set finds them, and least squares under constraints too. Source:
/// Kelley 1960, "The cutting-plane method for solving convex programs", Journal of SIAM 8; Goldman, Tucker
/// 1956, "Theory of linear programming".
///
/// `start` is the fit without constraints. The status is degenerate if the parameters depend on each other,
/// with their names, and infeasible if no parameters satisfy the constraints.
StudyFit solve_linear_fit(const ReadStudy& study, const StudyError& error, Norm norm,
                          const Constraints& constraints, const std::vector<std::vector<StudyEdge>>& edges,
                          const SampledStudy<double>& sampled, const std::vector<double>& start,
                          const Checkpoint& checkpoint);

}  // namespace shadefit
