#pragma once

#include <array>

#include "approx/records/claim.hpp"
#include "approx/records/sources.hpp"
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

/// What `first` becomes where M is decoded instead of s: s/ln 2 = 2^(doublings g + first + log2(1/ln 2)).
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

/// exp(a) by the exponential that a GPU has: exp2(a/ln 2).
template <class T>
T exp_by_exp2(const T& a) {
  return exp2(a / ln2<T>());
}

/// log(a) by the logarithm that a GPU has: ln 2 log2(a), a > 0.
template <class T>
T log_by_log2(const T& a) {
  return ln2<T>() * log2(a);
}

/// A misprint of it: log2(a ln 2). It exceeds log(a) by (1 - ln 2) log2(a) + log2(ln 2), which is 0 at one
/// place alone, `misprinted_log_is_right_at`.
template <class T>
T misprinted_log_by_log2(const T& a) {
  return log2(a * ln2<T>());
}

/// a = (ln 2)^(-1/(1 - ln 2)).
template <class T>
T misprinted_log_is_right_at() {
  return exp2(-log2(ln2<T>()) / (integer<T>(1) - ln2<T>()));
}

/// The rows of the ledger on this topic.
inline constexpr std::array gloss_claims{
    Claim{.id = "gloss-log2-constant",
          .statement =
              "the constant 1 + log2(1/ln 2) that decodes a gloss g to M = s/ln 2 = 2^(10 g + constant)",
          .printed = {{"", "1.528766"}},
          .inputs = {{"doublings", "10"}, {"first", "1"}, {"from", "0"}, {"to", "1"}, {"steps", "16"}},
          .derivation =
              "s/ln 2 = 2^(10 g + 1) 2^(log2(1/ln 2)). At 50 digits, log2 once by the natural logarithm "
              "and once by squaring, one binary digit a step. A constant that is off by d multiplies "
              "every power by 2^d, whatever the gloss.",
          .source = sources::lagarde_2012},
    Claim{.id = "gloss-ln2-over-8",
          .statement = "ln 2/8, the factor of M in the normalisation (s+2)/8 = M ln 2/8 + 1/4, M = s/ln 2",
          .printed = {{"", "0.08664"}},
          .inputs = {{"doublings", "10"}, {"first", "1"}, {"from", "0"}, {"to", "1"}, {"steps", "16"}},
          .derivation = "At 50 digits, log(2) once as the constant and once as the binary logarithm of e by "
                        "squaring, inverted. The relative error of the normalisation grows with s/(s+2).",
          .source = sources::lagarde_2012},
    Claim{.id = "gloss-decode",
          .statement = "s = 2^(10 g + 1) maps a gloss g in [0,1] to specular powers 2 to 2048",
          .printed = {{"lowest", "2"}, {"highest", "2048"}},
          .inputs = {{"doublings", "10"}, {"first", "1"}, {"from", "0"}, {"to", "1"}, {"levels", "256"}},
          .derivation =
              "It rises with g, so its range is from one end to the other: whole powers of two, exact in "
              "float and half alike. Each of the 255 steps of an 8-bit gloss multiplies the power by "
              "2^(10/255).",
          .source = sources::lagarde_2011_adopting},
    Claim{.id = "exp2-identity",
          .statement = "exp(a) = exp2(a/ln 2)",
          .inputs = {{"from", "-1000"}, {"to", "1000"}, {"steps", "40"}, {"agreement", "1e-45"}},
          .derivation =
              "e = 2^(1/ln 2). Both sides at 50 digits: e^a by its series, 2^x without any logarithm, as "
              "the product of the square roots of 2, of its root, .. that the binary digits of x name. "
              "Rounding leaves |a| times 1e-50, hence the bound. The exponents are those that an SG of "
              "power 1000 meets.",
          .source = sources::lagarde_2012},
    Claim{.id = "gloss-normalised-mad",
          .statement = "(s+2)/8 = M*0.08664 + 0.25 for M = s/ln 2: the normalisation is one multiply-add",
          .inputs = {{"factor", "0.08664"},
                     {"constant", "0.25"},
                     {"doublings", "10"},
                     {"first", "1"},
                     {"from", "0"},
                     {"to", "1"},
                     {"steps", "16"},
                     {"agreement", "1e-45"}},
          .derivation =
              "M ln 2 = s. The identity is judged with the closed form ln 2/8 of the factor, to which the "
              "printed one has to round; its constant as printed. The effect is that of the printed factor. "
              "Both sides at 50 digits differ by their rounding alone, hence the bound.",
          .source = sources::lagarde_2012},
    Claim{.id = "log2-identity-first",
          .statement = "the first version of the post: log(a) = log2(a*log(2))",
          .inputs = {{"from", "-20"}, {"to", "20"}, {"steps", "40"}, {"agreement", "1e-45"}},
          .derivation =
              "a = 2^u, u from -20 to 20. log2(a ln 2) - log(a) = (1 - ln 2) u + log2(ln 2), which is 0 "
              "for one u only: an identity that holds at one place is none. The product belongs outside: "
              "log(a) = log(2)*log2(a).",
          .source = sources::lagarde_2012_first},
    Claim{.id = "log2-identity-second",
          .statement = "the second version of the post: log(a) = log(2)*log2(a)",
          .inputs = {{"from", "-20"}, {"to", "20"}, {"steps", "40"}, {"agreement", "1e-45"}},
          .derivation =
              "a = 2^u, u from -20 to 20, and a third of it, so that not every logarithm is whole. log2 at "
              "50 digits by squaring, one binary digit a step, and log by its own series: rounding leaves "
              "about |log(a)| times 1e-50, hence the bound.",
          .source = sources::lagarde_2012},
};

}  // namespace shadefit
