#pragma once

#include "approx/scalar.hpp"

/// Gloss: how a stored gloss in [0, 1] becomes a specular power, and the lobe of that power by exp2.
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

/// The spherical Gaussian with M given: exp2(M c - M), c in [0, 1].
template <class T>
T gaussian_lobe_base_two(const T& cos_theta, const T& base_two) {
  return exp2(base_two * cos_theta - base_two);
}

/// (s + 2)/8: the normalisation of a microfacet lobe in a game's light unit.
template <class T>
T game_normalisation(const T& exponent) {
  return (exponent + integer<T>(2)) / integer<T>(8);
}

}  // namespace shadefit
