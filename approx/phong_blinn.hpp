#pragma once

#include "approx/lobe.hpp"
#include "approx/scalar.hpp"

/// The Phong lobe cos^rho(theta), theta between reflected ray and view, by the Blinn lobe cos^(x
/// rho)(theta/2) of the half vector: in a plane the Phong angle is twice the Blinn angle. rho > 0 is the
/// Phong exponent, x the factor between the exponents, y = 1 - cos(theta).
namespace shadefit {

/// cos^(x rho)(theta/2) from c = cos(theta): ((1 + c)/2)^(x rho/2).
template <class T>
T blinn_lobe_of_cosine(const T& cos_theta, const T& exponent, const T& factor) {
  const T two = integer<T>(2);
  return power((integer<T>(1) + cos_theta) / two, factor * exponent / two);
}

/// The same from y: ((1 + cos)/2)^(x rho/2) = exp(x rho/2 log1p(-y/2)).
template <class T>
T blinn_lobe(const T& one_minus_cos, const T& exponent, const T& factor) {
  return half_angle_power(one_minus_cos, factor * exponent);
}

/// log(cos(theta/2)) = log1p(-y/2)/2 from y and R = log1p_remainder(-y/2), which `phong_blinn_log_ratio`
/// needs too.
template <class T>
T log_half_cosine(const T& one_minus_cos, const T& half_remainder) {
  const T two = integer<T>(2);
  return (half_remainder - one_minus_cos / two) / two;
}

/// log of cos^rho(theta) over cos^(4 rho)(theta/2). It does not depend on the factor x: rho (log(1-y) - 2
/// log(1-y/2)). Both terms begin with -y, which cancels: the first term is `lobe_log_ratio`, the second comes
/// from R = log1p_remainder(-y/2). With h = log(cos(theta/2)) this is the L of `lobe_error` for the base
/// exp(4 rho h) and the change (x - 4) rho h.
template <class T>
T phong_blinn_log_ratio(const T& lobe_log_ratio, const T& half_remainder, const T& exponent) {
  return lobe_log_ratio - integer<T>(2) * exponent * half_remainder;
}

/// The least-squares factor for large rho under a measure y^(p-1) dy (1 + ..) near the peak: 4 + (p+2)/(2
/// rho).
///
/// With t = rho y and x = 4 + d, cos^rho = exp(-t - t^2/(2 rho) - ..) and the Blinn lobe is
/// exp(-t - d t/4 - t^2/(4 rho) - ..); their difference, exp(-t) (t^2/(4 rho) - d t/4), has to be orthogonal
/// to t exp(-t): g(p+3)/rho = d g(p+2) with g(n) = Gamma(n)/2^n. Cosine: 4 + 3/(2 rho); angle: 4 + 5/(4 rho).
template <class T>
ApproachLaw<T> factor_law(const T& p) {
  return {integer<T>(4), (p + integer<T>(2)) / integer<T>(2)};
}

}  // namespace shadefit
