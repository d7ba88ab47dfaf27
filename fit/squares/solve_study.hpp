#pragma once

#include <vector>

#include "fit/study/study.hpp"
#include "fit/study/study_fit.hpp"
#include "fit/support/checkpoint.hpp"

/// The least-squares fit of a study.
namespace shadefit {

/// Fits a study. Parameters that enter linearly are eliminated (variable projection: Golub, Pereyra 1973,
/// "The Differentiation of Pseudo-Inverses and Nonlinear Least Squares Problems Whose Variables Separate",
/// SIAM Journal on Numerical Analysis 10; the Jacobian is Kaufman's, 1975, "A variable projection method for
/// solving separable nonlinear least squares problems", BIT 15). The others start from a low-discrepancy set.
/// Ceres descends, Newton with the exact Hessian finishes, and another rule in long double counts the digits.
/// Of measured rows the mean square is a sum over the rows, and long double counts the digits on the same
/// rows. Throws UserError where a formula has no value in the range.
StudyFit solve_study(const ReadStudy& study, const std::vector<Held>& starts,
                     const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit
