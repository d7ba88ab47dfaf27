#pragma once

#include <span>

#include "approx/scalar.hpp"

/// Other kernels for a lobe: Gauss-Weierstrass and Abel-Poisson, as printed and on the sphere, with their
/// peak scaled to 1. theta is the angle to the lobe's axis in radians, c its cosine, y = 1 - c.
namespace shadefit {

/// The Gauss-Weierstrass kernel of the line, exp(-x^2/(2 t)); t > 0. At the angle x = theta it is a lobe. At
/// the chord x = |n - l|, x^2 = 2 y, it is exp(-y/t), the spherical Gaussian of sharpness 1/t.
template <class T>
T line_gaussian(const T& x, const T& variance) {
  return exp(-(x * x / (integer<T>(2) * variance)));
}

/// The Abel-Poisson kernel of the circle as printed, (1 - t^2)/(1 - 2 t c + t^2), 0 < t < 1, over its peak
/// (1 + t)/(1 - t): 1 - 2 t c + t^2 = (1 - t)^2 + 2 t y, so it is 1/(1 + m y) of the sharpness m = 2 t/(1 -
/// t)^2.
template <class T>
T poisson_of_circle_lobe(const T& one_minus_cos, const T& sharpness) {
  return integer<T>(1) / (sharpness * one_minus_cos + integer<T>(1));
}

/// The Abel-Poisson kernel of the sphere, (1 - t^2)/(1 - 2 t c + t^2)^(3/2), over its peak (1 + t)/(1 - t)^2:
/// (1 + m y)^(-3/2). Source: Freeden, Gervens, Schreiner 1998, "Constructive Approximation on the Sphere".
template <class T>
T poisson_of_sphere_lobe(const T& one_minus_cos, const T& sharpness) {
  const T base = sharpness * one_minus_cos + integer<T>(1);
  return integer<T>(1) / (base * sqrt(base));
}

/// The next Legendre polynomial, P_(l+1)(c) = ((2 l + 1) c P_l - l P_(l-1))/(l + 1), from P_l and P_(l-1).
template <class T>
T next_legendre(const T& cos_theta, const T& current, const T& before, int l) {
  return (integer<T>(2 * l + 1) * cos_theta * current - integer<T>(l) * before) / integer<T>(l + 1);
}

/// The weight of P_l in the Gauss-Weierstrass (heat) kernel of the sphere: (2 l + 1) e^(-l (l + 1) t), t > 0.
/// Source: Freeden, Gervens, Schreiner 1998, "Constructive Approximation on the Sphere".
template <class T>
T heat_weight(int l, const T& t) {
  return integer<T>(2 * l + 1) * exp(-(integer<T>(l) * integer<T>(l + 1) * t));
}

/// The sum of weights[l] P_l(c), at least two terms. With `heat_weight` it is the heat kernel, whose peak is
/// the sum of the weights.
template <class T>
T legendre_series(const T& cos_theta, std::span<const T> weights) {
  T before = integer<T>(1), current = cos_theta;
  T sum = weights[0] + weights[1] * cos_theta;
  for (std::size_t l = 2; l < weights.size(); ++l) {
    const T next = next_legendre(cos_theta, current, before, static_cast<int>(l) - 1);
    sum = sum + weights[l] * next;
    before = current;
    current = next;
  }
  return sum;
}

/// For sharp lobes, the error of the best Gaussian of the angle is 2/3 of the error of the best spherical
/// Gaussian.
///
/// With u = theta sqrt(k), c^k = e^(-u^2/2) (1 - u^4/(12 k) + ..). The spherical Gaussian is e^(-u^2/2) (1 +
/// u^4/(24 k) - x u^2/(2 k) + ..), the Gaussian of the angle has no term in u^4. The error of the first is
/// u^4/8 - x u^2/2; that of the second is u^4/12 - x' u^2/2, which is 2/3 of the first for x' = 2 x/3. The
/// heat kernel differs from the Gaussian of the angle by sqrt(theta/sin theta) = 1 + u^2/(12 k) + .., which
/// only moves x'.
template <class T>
T gaussian_error_ratio() {
  const T of_angle = integer<T>(1) / integer<T>(12), spherical = integer<T>(1) / integer<T>(8);
  return of_angle / spherical;
}

}  // namespace shadefit
