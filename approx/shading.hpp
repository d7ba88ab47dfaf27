#pragma once

#include <cstddef>

#include "approx/scalar.hpp"

/// The specular term of one light as used in games, F (n + 2)/8 c^n (n.l), and the forms of its lobe from
/// which a scene plan chooses. c = n.h, n the specular exponent.
namespace shadefit {

/// The base-two logarithm of a cosine near 1 as y (s1 + y (s2 + ..)), y = c - 1 in [-1, 0]: Taylor's slopes
/// are 1/ln 2, -1/(2 ln 2), 1/(3 ln 2) .. `slopes` is an array of T, at least one.
template <class T, class Slopes>
T log2_by_slopes(const T& cos_minus_one, const Slopes& slopes) {
  std::size_t i = slopes.size() - 1;
  T sum = slopes[i];
  while (i > 0) sum = slopes[--i] + cos_minus_one * sum;
  return cos_minus_one * sum;
}

/// The lobe c^n from the slopes multiplied by n: exp2(y (A1 + y (A2 + ..))), y = c - 1, c in [0, 1]. With one
/// slope it is the spherical Gaussian exp2(A (c - 1)); the difference c - 1 is exact for c >= 1/2 (Sterbenz
/// 1974, "Floating-Point Computation"), whereas A c - A cancels.
template <class T, class Slopes>
T sloped_lobe(const T& cos_theta, const Slopes& slopes) {
  return exp2(log2_by_slopes(T(cos_theta - integer<T>(1)), slopes));
}

/// The same for an exponent per pixel: exp2(n y (s1 + y (s2 + ..))).
template <class T, class Slopes>
T sloped_lobe(const T& cos_theta, const T& exponent, const Slopes& slopes) {
  return exp2(exponent * log2_by_slopes(T(cos_theta - integer<T>(1)), slopes));
}

/// F0 + (F90 - F0) s: Schlick's reflectance between F0 and F90, s the weight of the angle.
template <class T>
T reflectance_between(const T& f0, const T& f90, const T& weight) {
  return f0 + (f90 - f0) * weight;
}

/// min(n.l, 2 n.h). l = 2 (h.l) h - v, so n.l = 2 (h.l) (n.h) - n.v <= 2 n.h for n.v >= 0: then the result is
/// n.l. A normal map can turn a normal away from the viewer, n.v < 0; then 2 n.h bounds the light of a half
/// vector at the horizon.
template <class T>
T seen_light(const T& n_dot_l, const T& n_dot_h) {
  return min(n_dot_l, T(n_dot_h + n_dot_h));
}

/// The specular term of one light as displayed, clamped: min(F g t (n.l), 1), g the normalisation, t the
/// lobe.
template <class T>
T shown_specular(const T& reflectance, const T& normalisation, const T& lobe, const T& n_dot_l) {
  return min(T(reflectance * normalisation * lobe * n_dot_l), integer<T>(1));
}

}  // namespace shadefit
