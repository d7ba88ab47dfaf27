#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "fit/steps/positive_definite.hpp"
#include "fit/steps/sums.hpp"

/// Newton's step and what it tells.
namespace shadefit {

/// The inverse of a Hessian.
ParameterMatrix<double> inverse(const ParameterMatrix<double>& hessian);

/// The Newton step -H^-1 g. The gradient may be in wider arithmetic than the Hessian, whose own rounding only
/// shortens or lengthens a step.
template <class T>
ParameterVector<T> newton_step(const ParameterVector<T>& gradient, const ParameterMatrix<double>& hessian) {
  const ParameterMatrix<double> inverted = inverse(hessian);
  ParameterVector<T> step(gradient.size());
  for (Eigen::Index i = 0; i < step.size(); ++i) {
    step[i] = 0;
    for (Eigen::Index j = 0; j < step.size(); ++j) step[i] -= static_cast<T>(inverted(i, j)) * gradient[j];
  }
  return step;
}

/// Whether a point with this Hessian is a minimum.
bool is_minimum(const ParameterMatrix<double>& hessian);

/// The largest |step / parameter|. A parameter whose optimum is 0 has no relative digits and never settles.
template <class T>
T relative_size(const ParameterVector<T>& step, const ParameterVector<T>& p) {
  T largest = 0;
  for (Eigen::Index i = 0; i < step.size(); ++i) {
    if (step[i] != 0) largest = std::max(largest, std::abs(step[i] / p[i]));
  }
  return largest;
}

/// Corrects a Hessian by the change of the gradient along a step (symmetric rank one; with one parameter: the
/// secant). A change that was expected corrects nothing. Source:
/// Nocedal, Wright 2006, "Numerical Optimization", 6.2.
void correct(ParameterMatrix<double>& hessian, const ParameterVector<double>& step,
             const ParameterVector<double>& change);

}  // namespace shadefit
