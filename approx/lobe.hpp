#pragma once

#include <array>
#include <string_view>

#include "approx/records/claim.hpp"
#include "approx/records/record.hpp"
#include "approx/records/sources.hpp"
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

/// log of c^k over the plain Gaussian exp(k(c - 1)): k (log(c) + y) <= 0. Free of the offset. Near the peak
/// log(c) is taken from y, where the sum would cancel; near c = 0 from c, which y = 1 - c has lost there.
template <class T>
T lobe_log_ratio(const T& cos_theta, const T& one_minus_cos, const T& exponent) {
  const auto near_horizon = [&] { return log(cos_theta) + one_minus_cos; };
  const auto near_peak = [&] { return log1p_remainder(-one_minus_cos); };
  return exponent * T(choose(less(cos_theta, one_minus_cos), near_horizon, near_peak));
}

/// form - target without cancellation, for a form base * exp(change) and a target base * exp(L): base
/// (expm1(change) - expm1(L)). Near the peak of a lobe both exponents are small against that of the base, and
/// the plain difference would lose log10(k) digits. `change` is what of the form depends on its parameter,
/// `ratio_minus_one` = expm1(L); L = -infinity (a target of 0) gives the form itself. The spherical Gaussian:
/// base exp(-k y), change -x y, L `lobe_log_ratio`.
template <class T>
T lobe_error(const T& base, const T& change, const T& ratio_minus_one) {
  return base * (expm1(change) - ratio_minus_one);
}

/// form / target - 1 for the same: expm1(change - L).
template <class T>
T lobe_relative_error(const T& change, const T& log_ratio) {
  return expm1(change - log_ratio);
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

/// form / target - 1 for the same: (scale - 1) + scale expm1(change - L).
template <class T>
T scaled_lobe_relative_error(const T& scale, const T& change, const T& log_ratio) {
  return (scale - integer<T>(1)) + scale * lobe_relative_error(change, log_ratio);
}

/// How a quantity approaches its limit as k grows: x(k) = limit + slope / k + O(1/k^2).
template <class T>
struct ApproachLaw {
  T limit;
  T slope;
};

/// The law of the least-squares offset under a measure that is y^(p-1) (1 + w y + ..) dy near the peak:
/// p = 1, w = 0 for the cosine measure dc; p = 1/2, w = 1/4 for the angle, d theta = dy / sqrt(2y - y^2).
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

inline constexpr Family sg_offset{
    .id = "sg-offset",
    .title = "Spherical Gaussian offset",
    .variables = "c = n.h or r.v, the cosine to the lobe's axis; k the specular exponent; x the offset",
    .sweep = "1:15:1,25,50,100,1000,10000,1000000",
    .curve = {.trend = Trend::falls, .is_non_negative = true, .is_at_most_one = true}};

inline constexpr Family sg_scaled{
    .id = "sg-scaled",
    .title = "Spherical Gaussian, scale and offset",
    .variables =
        "c = n.h or r.v, the cosine to the lobe's axis; k the specular exponent; A the peak, x the offset",
    .sweep = sg_offset.sweep,
    .is_comparison = true};

inline constexpr std::array sg_offset_published{
    Published{.id = "sg-offset-mean",
              .family = "sg-offset",
              .parameter = "x",
              .printed = "0.775",
              .statement = Statement::mean_of_fits,
              .exponents = "3:15:1",
              .convention = {},
              .source = sources::lagarde_2012,
              .variants = {}},
    Published{.id = "sg-offset-limit",
              .family = "sg-offset",
              .parameter = "x",
              .printed = "0.75",
              .statement = Statement::limit_of_fits,
              .exponents = "",
              .convention = {},
              .source = sources::lagarde_2012,
              .variants = {}},
    Published{.id = "sg-offset-k5",
              .family = "sg-offset",
              .parameter = "x",
              .printed = "0.788",
              .statement = Statement::best_fit,
              .exponents = "5",
              .convention = {},
              .source = sources::lagarde_2012,
              .variants = {}},
};

/// The rows of the ledger on this topic.
inline constexpr std::array lobe_claims{
    claim_of(
        sg_offset_published[0], "c^k ~ exp((k+x)(c-1)): the mean of the best x over integer k = 3..15",
        "Each x is a continuous least-squares fit, uniform in the cosine; the mean is over the exponents of "
        "the input.",
        "offset"),
    claim_of(sg_offset_published[1], "the best x of exp((k+x)(c-1)) as k grows",
             "With t = k(1-c) the condition of the minimum is an integral of powers of t times exp(-2t): "
             "x = (p+2)/4, p = 1 for dc. The fits at k = 1e4, 1e5, 1e6, extrapolated in 1/k, have to agree.",
             "offset"),
    claim_of(sg_offset_published[2], "the best x of exp((k+x)(c-1)) at k = 5",
             "A continuous least-squares fit, uniform in the cosine; the published one-term Fresnel form is "
             "this lobe in 1 - c.",
             "offset"),
    Claim{
        .id = "sg-offset-bounds",
        .statement =
            "the best x of exp((k+x)(c-1)) lies between 0 and 1 for every specular power k; x = 1 is "
            "the literature's choice (the concentration of a von Mises-Fisher density), x = 0 the "
            "plain form",
        .printed = {{"lowest", "0"}, {"highest", "1"}},
        .inputs = {{"exponents", "0.001,0.1,0.5,1:15:1,25,100,1000,100000"}},
        .derivation =
            "c <= exp(c-1), so the plain form is nowhere below c^k: under every measure the cost falls as x "
            "leaves 0, and the best x is above 0. Blunt lobes: c^k = 1 + k log(c), a linear problem, x = "
            "slope k. Sharp lobes: x = limit + slope/k with t = k(1-c). Between them the largest x is looked "
            "for among the fits. x = 1 is no least-squares fit: it gives the lobe its integral, 1/(k+1), but "
            "for exp(-(k+1)).",
        .figure = "offset",
        .source = sources::lagarde_2012},
    Claim{
        .id = "sg-plain-accurate",
        .statement = "exp(k(c-1)) is accurate above k = 15 and poor below 8; k = 1 and 2 are bad for every "
                     "offset x of exp((k+x)(c-1)), and only they among the whole powers",
        .printed = {{"accurate above", "15"}, {"poor below", "8"}, {"bad up to", "2"}},
        .inputs = {{"offset", "0"},
                   {"accurate", "0.02"},
                   {"poor", "0.035"},
                   {"bad", "0.05"},
                   {"from", "0.1"},
                   {"to", "100000"}},
        .derivation =
            "The words are read as the largest absolute error over c in [0,1]: accurate at or below 0.02, poor "
            "above 0.035, bad above 0.05. At a fixed t = k(1-c) the plain form is e^(-t) whatever k, and c^k "
            "= (1 - t/k)^k grows with k: the error falls everywhere, and each threshold is a single one. "
            "It goes as 2/(e^2 k): e^(-t) t^2/(2k) at t = 2.",
        .figure = "lobe-errors",
        .source = sources::lagarde_2012},
    Claim{
        .id = "sg-plain-peak",
        .statement = "near the peak exp(k(c-1)) is nearer to c^k than exp((k+0.775)(c-1)): from a cosine "
                     "on, which depends on k",
        .inputs = {{"offset", "0.775"}, {"exponents", "1:15:1,25,50,100,1000,10000"}},
        .derivation =
            "Both errors are equal where 1 + exp(-x y) = 2 c^k/exp(-k y), y = 1-c. The log of one over the "
            "other is convex in y, 0 at the peak and falling there: one crossing for every k. With t = k y it "
            "is t = x - (2/3 + x/4) x^2/k + ..",
        .figure = "lobe-errors",
        .source = sources::lagarde_2012},
    Claim{
        .id = "sg-offset-one-low",
        .statement = "exp((k+1)(c-1)) fits low specular powers nicely, and at high powers the +1 can be "
                     "dropped",
        .printed = {{"x", "1"}},
        .inputs = {{"low from", "3"},
                   {"low to", "15"},
                   {"high from", "15"},
                   {"high to", "100000"},
                   {"nicely", "0.035"},
                   {"accurate", "0.02"},
                   {"subtle", "0.03"},
                   {"used at", "5"}},
        .derivation =
            "Low are the powers 3 to 15 for which the author's other post fits an offset, high those above, "
            "where it calls the plain form accurate; nicely is read as not poor, the largest absolute error "
            "over c in [0,1] at or below 0.035, and dropped as: the two forms differ by less than 0.03. "
            "The difference of sharpness a < b has a closed form, (a/b)^(a/(b-a)) (b-a)/b. The post itself "
            "uses x = 1 at k = 5, for Fresnel.",
        .figure = "lobe-errors",
        .source = sources::lagarde_2011_adopting},
    Claim{
        .id = "sg-offset-matters-below",
        .statement = "from k = 10 on the difference between the offsets x = 0, 0.775 and 1 of "
                     "exp((k+x)(c-1)) is subtle",
        .printed = {{"k", "10"}},
        .inputs = {{"plain", "0"},
                   {"fitted", "0.775"},
                   {"literature", "1"},
                   {"subtle", "0.03"},
                   {"from", "0.1"},
                   {"to", "100000"}},
        .derivation =
            "Subtle: the curves differ by less than 0.03 anywhere. The largest difference of sharpness a < b "
            "is at y = log(b/a)/(b-a), where it is (a/b)^(a/(b-a)) (b-a)/b. At a fixed t = k(1-c) it falls as "
            "k grows, as (b-a)/(e k) in the end: one threshold for each pair.",
        .figure = "lobe",
        .source = sources::lagarde_2012},
};

}  // namespace shadefit
