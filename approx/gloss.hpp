#pragma once

#include "approx/scalar.hpp"

/// Gloss: how a stored gloss in [0, 1] becomes a specular power, and the identities of logarithms behind it.
/// g is the gloss, s = k the specular power, M = s/ln 2 the same power for exp2.
namespace shadefit {

/// The specular power of a gloss: s = 2^(doublings g + first), from 2^first at g = 0 to 2^(doublings + first)
/// at g = 1. Source: Lagarde 2011, "Adopting a physically based shading model" (10 and 1).
template <class T>
T decode_gloss(const T& gloss, const T& doublings, const T& first) {
  return exp2(doublings * gloss + first);
}

/// M = s/ln 2, with which exp(s(c-1)) = exp2(M c - M).
template <class T>
T base_two_power(const T& exponent) {
  return exponent / ln2<T>();
}

/// The value of `first` that decodes M instead of s: s/ln 2 = 2^(doublings g + first + log2(1/ln 2)).
template <class T>
T base_two_first(const T& first) {
  return first + log2(integer<T>(1) / ln2<T>());
}

/// The exponent of `gaussian_lobe_base_two`, M c - M: 0 at c = 1.
template <class T>
T gaussian_exponent_base_two(const T& cos_theta, const T& base_two) {
  return base_two * cos_theta - base_two;
}

/// The spherical Gaussian with M given: exp2(M c - M), c in [0, 1].
template <class T>
T gaussian_lobe_base_two(const T& cos_theta, const T& base_two) {
  return exp2(gaussian_exponent_base_two(cos_theta, base_two));
}

/// ln 2/8, the factor of M in a normalisation.
template <class T>
T base_two_normalisation_factor() {
  return ln2<T>() / integer<T>(8);
}

/// (s + 2)/8: the normalisation of a microfacet lobe in a game's light unit.
template <class T>
T game_normalisation(const T& exponent) {
  return (exponent + integer<T>(2)) / integer<T>(8);
}

/// The same as one fused multiply-add of M: factor M + constant.
template <class T>
T base_two_normalisation(const T& base_two, const T& factor, const T& constant_term) {
  return base_two * factor + constant_term;
}

/// exp(a) by exp2, which a GPU has: exp2(a/ln 2).
template <class T>
T exp_by_exp2(const T& a) {
  return exp2(a / ln2<T>());
}

/// log(a) by log2, which a GPU has: ln 2 log2(a), a > 0.
template <class T>
T log_by_log2(const T& a) {
  return ln2<T>() * log2(a);
}

/// A misprint of log(a): log2(a ln 2). It exceeds log(a) by (1 - ln 2) log2(a) + log2(ln 2). The difference
/// is 0 only at `misprinted_log_is_right_at`.
template <class T>
T misprinted_log_by_log2(const T& a) {
  return log2(a * ln2<T>());
}

/// a = (ln 2)^(-1/(1 - ln 2)).
template <class T>
T misprinted_log_is_right_at() {
  return exp2(-log2(ln2<T>()) / (integer<T>(1) - ln2<T>()));
}

}  // namespace shadefit
