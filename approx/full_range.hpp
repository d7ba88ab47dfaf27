#pragma once

#include "approx/arithmetic.hpp"
#include "approx/fresnel.hpp"
#include "approx/gloss.hpp"
#include "approx/lobe.hpp"
#include "approx/normalisation.hpp"
#include "approx/scalar.hpp"

/// Forms that are safe for every argument in every format, including half. The printed formulas can give NaN,
/// infinity, negative values or values above 1 there, or lose their digits. Each form is the printed formula,
/// rearranged; `shadefit stress` states its error bound and tries to break it.
namespace shadefit {

/// A dot product clamped to a cosine in [0, 1]. The dot product exceeds 1 if the vectors are slightly longer
/// than 1; it is negative on the far side.
template <class T>
T unit_cosine(const T& dot) {
  return min(positive_part(dot), integer<T>(1));
}

/// c^k of a dot product; k >= 0. In [0, 1] for every dot product.
template <class T>
T power_lobe_of_dot(const T& dot, const T& exponent) {
  return power_lobe(unit_cosine(dot), exponent);
}

/// The same as a GPU computes it, exp2(k log2(c)). 0^0 is 1 here. `power_by_exp2` gives NaN for 0^0 and for
/// every negative number.
template <class T>
T power_by_exp2_of_dot(const T& dot, const T& exponent) {
  const T zero = integer<T>(0), one = integer<T>(1);
  const T at_zero = select(less(zero, exponent), zero, one);
  return select(less(zero, dot), power_by_exp2(T(min(dot, one)), exponent), at_zero);
}

/// `gaussian_lobe_base_two_of_difference` of a dot product: at most 1.
template <class T>
T gaussian_lobe_base_two_of_dot(const T& dot, const T& base_two) {
  return gaussian_lobe_base_two_of_difference(unit_cosine(dot), base_two);
}

/// `schlick_weight` of a dot product: in [0, 1]. The plain formula is negative beyond c = 1.
template <class T>
T schlick_weight_of_dot(const T& dot) {
  return schlick_weight(unit_cosine(dot));
}

/// `decode_gloss` with 2^first as a separate factor: 2^(doublings g) 2^first. The sum doublings g + first
/// would add a rounding, 2^-8 in half near the upper end. The gloss is clamped to [0, 1], because a texture
/// filter may return a value just above 1.
template <class T>
T decode_clamped_gloss(const T& gloss, const T& doublings, const T& first) {
  return exp2(doublings * unit_cosine(gloss)) * exp2(first);
}

/// `von_mises_fisher` for every k >= 0, including the uniform density 1/(4 pi) at k = 0, from y = 1 - c:
/// k/(2 pi (1 - e^(-2k))) e^(-k y), since 2 sinh k = e^k (1 - e^(-2k)). k/(1 - e^(-2k)) is computed first: it
/// is 1/2 at k = 0 and loses no digits for a subnormal k. The exponential is split into two equal factors.
/// e^(-k y) alone can be subnormal, with few digits left, although its product with k is normal (in half from
/// k y = 10 on).
template <class T>
T von_mises_fisher_of_any_concentration(const T& one_minus_cos, const T& concentration) {
  const T zero = integer<T>(0), one = integer<T>(1), two = integer<T>(2);
  const T share = -expm1(-(two * concentration));
  const T peak = select(less(zero, concentration), T(concentration / share), T(one / two));
  const T half = exp(-(concentration * one_minus_cos / two));
  return peak / (two * pi<T>()) * half * half;
}

/// `henyey_greenstein` for every g in (-1, 1), from y = 1 - c: 1 + g^2 - 2 g c = b = (1 - g)^2 + 2 g y. For g
/// < 0 it uses -g and 1 + c = 2 - y, so nothing cancels on either side. In half the powers of 1 - |g| would
/// be subnormal from |g| = 0.99 on. Therefore everything is scaled by 64; a power of two changes no digit:
///   (1 - g^2)/(4 pi b^1.5) = (1 + |g|)/(4 pi) * 4096 (1 - |g|)/b' * 64/sqrt(b'),  b' = 4096 b.
template <class T>
T henyey_greenstein_from_both_sides(const T& one_minus_cos, const T& g) {
  const T zero = integer<T>(0), one = integer<T>(1), scale = integer<T>(64), square = integer<T>(4096);
  const T size = max(g, T(-g));
  const T from_peak = select(less(g, zero), T(integer<T>(2) - one_minus_cos), one_minus_cos);
  const T rest = one - size;
  const T base = (scale * rest) * (scale * rest) + integer<T>(8192) * size * from_peak;
  return (one + size) / (integer<T>(4) * pi<T>()) * (square * rest / base) * (scale / sqrt(base));
}

/// `BlinnPhongBrdfLobe::constant` as a product of two quotients. (a+2)(a+4) overflows in half from a = 253
/// on, where the constant itself is 10.
template <class T>
T blinn_phong_brdf_constant_by_parts(const T& alpha) {
  const T two = integer<T>(2);
  const T near_one = (alpha + two) / (exp2(-(alpha / two)) + alpha);
  return near_one * ((alpha + integer<T>(4)) / (integer<T>(8) * pi<T>()));
}

}  // namespace shadefit
