#pragma once

#include <vector>

#include "fit/exchange/linear_cuts.hpp"

namespace shadefit {

/// Whether parameters satisfy constraints, up to a small share of the error at the start.
bool keeps_constraints(const LinearProblem& problem, const std::vector<double>& parameters);

/// The fit of a form that is linear in its parameters, under either norm and any constraints.
///
/// The problem is convex. Its conditions, that a curve is below its
/// bound at each place, are linear. A programme (fit/exchange/linear_programmes.hpp) solves it at the
/// places so far. Then the places where a curve is highest and above its bound join the set, until no curve
/// is above its bound. The level of the linear programme is a lower bound for all parameters, by duality,
/// and it rises to the least level.
///
/// Newton's method (fit/exchange/linear_newton.hpp) in long double gives the digits. Because the places
/// move, fewer than n + 1 places can determine n parameters. Where these do not, many parameters have the
/// least level. Of them those with the least mean square are the answer: each has the same error at the
/// places of the level, and the error is stationary there. A quadratic programme finds them, and least
/// squares under constraints too. Source: Goldman, Tucker 1956, "Theory of linear programming".
///
/// The status is degenerate if the parameters depend on each other, with their names, and infeasible if no
/// parameters satisfy the constraints.
StudyFit solve_linear_fit(const LinearProblem& problem);

}  // namespace shadefit
