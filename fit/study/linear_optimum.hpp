#pragma once

#include <optional>

#include "fit/study/study_problem.hpp"

namespace shadefit {

/// The least squares of a form that is linear in all its parameters.
struct LinearOptimum {
  VectorOf<long double> parameters;
  VectorOf<long double> last_step;  ///< of its refinement, which is rounding
  VectorOf<long double> sizes;      ///< how much a parameter of 1 moves the form: a root mean square
  long double square = 0;           ///< of the error
};

/// Solved in long double, by orthogonal columns. The Hessian would have the square of their condition number:
/// for x^0 to x^7 on [0, 1] this is 1e10, and for x^15 it is beyond a double. Empty if the columns are
/// dependent up to the rounding of long double.
std::optional<LinearOptimum> linear_optimum(const SampledStudy<long double>& sampled);

}  // namespace shadefit
