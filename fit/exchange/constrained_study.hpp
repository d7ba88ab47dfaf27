#pragma once

#include <string>
#include <vector>

#include "fit/study/study_fit.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/support/checkpoint.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {

/// Constraints that no parameters satisfy.
struct Infeasible : UserError {
  explicit Infeasible(const std::string& reason)
      : UserError("the form cannot satisfy the constraints: " + reason), why(reason) {}

  std::string why;  ///< "no parameters keep the form <= 0.9 at c = 0"
};

/// The least-squares fit of a study of one variable under constraints. Without constraints it is
/// `solve_study`.
///
/// It starts from the fit without constraints. The extrema of the constrained curves give linear conditions,
/// and a quadratic programme (`least_step`) gives the step. A place where a curve was extreme stays a
/// condition. Then Newton's method solves the Karush-Kuhn-Tucker equations: the gradient of the square is a
/// combination of the gradients of the constraints that touch, and these are at their bounds. Its residuals
/// are in long double, and another quadrature rule counts the digits. Source: Wilson 1963, "A simplicial
/// algorithm for concave programming" (sequential quadratic programmes); for conditions at all places
/// Hettich, Kortanek 1993, "Semi-infinite programming: theory, methods, and applications", SIAM Review 35.
///
/// `alternation` of the answer has the places where a constraint touches. The search for extrema is sampled,
/// and the answer is the best optimum near the fits without constraints. Throws UserError for constraints
/// that the study cannot have, or that no parameters satisfy.
StudyFit solve_constrained_study(const ReadStudy& study, const Constraints& constraints,
                                 const std::vector<Held>& starts, const Checkpoint& checkpoint = keep_going);

/// Whether there is a constraint other than held parameters.
bool has_constraints(const Constraints& constraints);

/// Whether a form without free parameters keeps constraints, up to a rounding of its values. `study` is one
/// of a variable.
bool keeps_constraints(const ReadStudy& study, const Constraints& constraints);

/// Whether the slopes of the error by the parameters depend on each other, where the form is linear in them:
/// then some parameters change together and the curve stays the same.
bool are_dependent(const SampledStudy<double>& sampled, const std::vector<double>& parameters);

}  // namespace shadefit
