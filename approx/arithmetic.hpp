#pragma once

#include "approx/gloss.hpp"
#include "approx/scalar.hpp"

/// A lobe computed in half, float and double: claims about zero, NaN and banding. A = k/ln 2 is the power for
/// exp2 of `base_two_power`.
namespace shadefit {

/// c^k as a GPU computes it: exp2(k log2(c)). c in [0, 1]; c = 0 gives exp2(-infinity) = 0 for k > 0 and
/// exp2(-infinity * 0) = NaN for k = 0.
template <class T>
T power_by_exp2(const T& cos_theta, const T& exponent) {
  return exp2(log2(cos_theta) * exponent);
}

/// The spherical Gaussian of `gaussian_lobe_base_two` with the subtraction first, exp2(A (c - 1)): c - 1 is
/// exact for c in [0.5, 1] in every format. The remaining rounding is relative to the exponent, not to A.
template <class T>
T gaussian_lobe_base_two_of_difference(const T& cos_theta, const T& base_two) {
  return exp2(base_two * (cos_theta - integer<T>(1)));
}

}  // namespace shadefit
