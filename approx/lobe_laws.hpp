#pragma once

#include "approx/lobe.hpp"
#include "approx/scalar.hpp"

/// Differences between spherical Gaussians and c^k, and between two spherical Gaussians: closed forms, and
/// limits for sharp and for blunt lobes. c, y = 1 - c, k and x as in approx/lobe.hpp.
namespace shadefit {

/// The y in [0, 1] of the largest difference between exp(-a y) and exp(-b y), 0 < a < b. There a exp(-a y) =
/// b exp(-b y), so y = log(b/a)/(b - a). For very blunt lobes this exceeds 1, and the horizon y = 1 is
/// returned.
template <class T>
T widest_gap_at(const T& a, const T& b) {
  return min(integer<T>(1), log1p((b - a) / a) / (b - a));
}

/// The largest difference of two spherical Gaussians of sharpness 0 < a < b over c in [0, 1]. In the interior
/// it is (a/b)^(a/(b-a)) (b-a)/b, which tends to (b-a)/(e a) as both grow.
template <class T>
T widest_gap(const T& a, const T& b) {
  const T y = widest_gap_at(a, b);
  return exp(-(a * y)) * -expm1(-((b - a) * y));
}

/// k times the largest |exp((k+x)(c-1)) - c^k| as k grows. With t = k(1-c) the difference is
/// e^(-t) (t^2/2 - x t)/k + O(1/k^2), whose slope is 0 at t = 1 + x +- sqrt(1 + x^2): 2/e^2 for x = 0.
template <class T>
T largest_error_law(const T& offset) {
  const T one = integer<T>(1), two = integer<T>(2);
  const T root = sqrt(one + offset * offset);
  const T far = one + offset + root;
  const T near = one + offset - root;
  const auto difference = [&](const T& t) { return T(exp(-t) * (t * t / two - offset * t)); };
  return max(difference(far), -difference(near));
}

/// log((1 + exp(-x y))/2) - log(c^k / exp(-k y)). It is 0 where the plain Gaussian is as far above c^k as the
/// Gaussian with offset x is below. It is negative nearer to the peak, where the plain Gaussian is closer.
///
/// It is convex in y, 0 at the peak and falls there with slope -x/2: its slope is
/// -x/(1 + exp(x y)) + k y/(1 - y), and both terms grow. So for every k and every x > 0 there is one
/// crossing.
template <class T>
T peak_crossing_residual(const T& cos_theta, const T& one_minus_cos, const T& exponent, const T& offset) {
  return log1p(expm1(-(offset * one_minus_cos)) / integer<T>(2)) -
         lobe_log_ratio(cos_theta, one_minus_cos, exponent);
}

/// The law of that crossing in t = k(1-c): -x t/(2k) + x^2 t^2/(8k^2) = -t^2/(2k) - t^3/(3k^2) gives
/// t = x - (2/3 + x/4) x^2/k + O(1/k^2).
template <class T>
ApproachLaw<T> peak_crossing_law(const T& offset) {
  const T slope = integer<T>(2) / integer<T>(3) + offset / integer<T>(4);
  return {offset, -(slope * offset * offset)};
}

/// The least-squares offset for small k: x = slope k. A blunt lobe is 1 + k log(c) and its Gaussian 1 - (k+x)
/// y, so the condition is linear: x/k + 1 = integral of -log(c) y / integral of y^2.
template <class T>
T blunt_offset_slope(const T& integral_of_log, const T& integral_of_square) {
  return integral_of_log / integral_of_square - integer<T>(1);
}

/// Uniform in the cosine, over [0, 1]: 3/4 over 1/3.
template <class T>
T blunt_offset_slope_cosine() {
  return blunt_offset_slope(integer<T>(3) / integer<T>(4), integer<T>(1) / integer<T>(3));
}

/// Uniform in the angle, over [0, pi/2]: (pi/2) log(2) - (1 - log(2)) over 3 pi/4 - 2.
template <class T>
T blunt_offset_slope_angle() {
  const T quarter = pi<T>() / integer<T>(4);
  return blunt_offset_slope(T(integer<T>(2) * quarter * ln2<T>() + ln2<T>() - integer<T>(1)),
                            T(integer<T>(3) * quarter - integer<T>(2)));
}

/// Weighted by the cosine: 1/4 - 1/9 over 1/12.
template <class T>
T blunt_offset_slope_cosine_weighted() {
  return blunt_offset_slope(integer<T>(5) / integer<T>(36), integer<T>(1) / integer<T>(12));
}

}  // namespace shadefit
