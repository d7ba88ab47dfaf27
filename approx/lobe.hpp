#pragma once

#include "approx/scalar.hpp"

/// The cosine lobe c^k and its spherical Gaussian. c = cos of the angle to the lobe's axis in [0, 1],
/// k > 0 the specular exponent, x the offset added to it, y = 1 - c.
namespace shadefit {

/// The lobe c^k of Phong (c = r.v) and Blinn-Phong (c = n.h).
template <class T>
T power_lobe(const T& cos_theta, const T& exponent) {
  return power(cos_theta, exponent);
}

/// The spherical Gaussian exp((k + x)(c - 1)): sharpness k + x, peak 1.
/// Source: Wang, Ren, Gong, Snyder, Guo 2009, "All-Frequency Rendering of Dynamic, Spatially-Varying
/// Reflectance".
template <class T>
T gaussian_lobe(const T& cos_theta, const T& exponent, const T& offset) {
  return exp((exponent + offset) * (cos_theta - integer<T>(1)));
}

/// c^k from y = 1 - c: exp(k log1p(-y)). Near the peak c^k by `power` multiplies the rounding of c by k.
template <class T>
T power_lobe_near_peak(const T& one_minus_cos, const T& exponent) {
  return exp(exponent * log1p(-one_minus_cos));
}

/// cos^a(theta/2) from y = 1 - cos(theta): ((1 + cos)/2)^(a/2) = exp(a/2 log1p(-y/2)).
template <class T>
T half_angle_power(const T& one_minus_cos, const T& exponent) {
  const T two = integer<T>(2);
  return exp(exponent / two * log1p(-(one_minus_cos / two)));
}

/// The spherical Gaussian from y = 1 - c: exp(-(k + x) y).
template <class T>
T gaussian_lobe_near_peak(const T& one_minus_cos, const T& exponent, const T& offset) {
  return exp(-((exponent + offset) * one_minus_cos));
}

/// log of c^k over the plain Gaussian exp(k(c - 1)): k (log(c) + y) <= 0. It does not depend on the offset.
/// Near the peak, where the sum would cancel, log(c) is computed from y. Near c = 0 it is computed from c,
/// because y = 1 - c has lost the digits of c.
template <class T>
T lobe_log_ratio(const T& cos_theta, const T& one_minus_cos, const T& exponent) {
  const auto near_horizon = [&] { return log(cos_theta) + one_minus_cos; };
  const auto near_peak = [&] { return log1p_remainder(-one_minus_cos); };
  return exponent * T(choose(less(cos_theta, one_minus_cos), near_horizon, near_peak));
}

/// form - target without cancellation, for a form base * exp(change) and a target base * exp(L): base
/// (expm1(change) - expm1(L)). Near the peak of a lobe, change and L are small compared with the exponent of
/// the base, and the plain difference would lose log10(k) digits. `change` is the part of the form's exponent
/// that depends on its parameter, `ratio_minus_one` = expm1(L); L = -infinity (a target of 0) gives the form
/// itself. The spherical Gaussian: base exp(-k y), change -x y, L `lobe_log_ratio`.
template <class T>
T lobe_error(const T& base, const T& change, const T& ratio_minus_one) {
  return base * (expm1(change) - ratio_minus_one);
}

/// A exp((k + x)(c - 1)): the spherical Gaussian with its peak at A.
template <class T>
T scaled_gaussian_lobe(const T& cos_theta, const T& exponent, const T& scale, const T& offset) {
  return scale * gaussian_lobe(cos_theta, exponent, offset);
}

/// `lobe_error` of a form scale * base * exp(change): base ((scale - 1) + scale expm1(change) - expm1(L)),
/// scale near 1.
template <class T>
T scaled_lobe_error(const T& base, const T& scale, const T& change, const T& ratio_minus_one) {
  return base * ((scale - integer<T>(1)) + scale * expm1(change) - ratio_minus_one);
}

/// The behaviour of a quantity for large k: x(k) = limit + slope / k + O(1/k^2).
template <class T>
struct ApproachLaw {
  T limit;
  T slope;
};

/// The least-squares offset for large k under a measure y^(p-1) (1 + w y + ..) dy near the peak: p = 1, w = 0
/// for the cosine measure dc; p = 1/2, w = 1/4 for the angle, d theta = dy / sqrt(2y - y^2).
///
/// With t = k y the condition  integral of measure * (M - T) M y = 0  for M = exp(-t - x t/k) and
/// T = exp(-t - t^2/(2k) - t^3/(3k^2) - ..) reads, g(n) = Gamma(n) / 2^n being the integral of t^(n-1)
/// e^(-2t):
///   order 1:    g(p+3)/2 - x0 g(p+2) = 0, so x0 = (p+2)/4;
///   order 1/k:  x1 g(p+2) = x0^2/2 g(p+3) + g(p+4)/3 - g(p+5)/8 + (w - x0)(g(p+4)/2 - x0 g(p+3)).
/// Below, a, b, d are g(p+3), g(p+4), g(p+5) over g(p+2). Cosine: 3/4 + 13/(64 k); angle: 5/8 + 185/(768 k).
template <class T>
ApproachLaw<T> offset_law(const T& p, const T& w) {
  const T two = integer<T>(2);
  const T a = (p + two) / two;
  const T b = a * (p + integer<T>(3)) / two;
  const T d = b * (p + integer<T>(4)) / two;
  const T x0 = a / two;
  const T x1 = x0 * x0 / two * a + b / integer<T>(3) - d / integer<T>(8) + (w - x0) * (b / two - x0 * a);
  return {x0, x1};
}

}  // namespace shadefit
