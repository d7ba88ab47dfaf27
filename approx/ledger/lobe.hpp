#pragma once

#include <array>

#include "approx/lobe.hpp"
#include "approx/records/claim.hpp"
#include "approx/records/sources.hpp"

/// The rows of the ledger: Lobes: Blinn-Phong and Phong by a spherical Gaussian.
namespace shadefit {

inline constexpr std::array lobe_claims{
    claim_of(
        sg_offset_published[0], "`c^k ~ exp((k+x)(c-1))`: the mean of the best `x` over integer `k = 3..15`",
        "Each x is a continuous least-squares fit, uniform in the cosine; the mean is over the exponents "
        "of the input.",
        "offset"),
    claim_of(sg_offset_published[1], "the best `x` of `exp((k+x)(c-1))` as `k` grows",
             "With t = k(1-c) the condition of the minimum is an integral of powers of t times exp(-2t): x = "
             "(p+2)/4, p = 1 for dc. The fits at k = 1e4, 1e5, 1e6, extrapolated in 1/k, have to agree.",
             "offset"),
    claim_of(sg_offset_published[2], "the best `x` of `exp((k+x)(c-1))` at `k = 5`",
             "A continuous least-squares fit, uniform in the cosine; the published one-term Fresnel form is "
             "this lobe in 1 - c.",
             "offset"),
    Claim{.id = "sg-offset-bounds",
          .statement =
              "the best `x` of `exp((k+x)(c-1))` lies between 0 and 1 for every specular power `k`; `x = 1` "
              "is the literature's choice (the concentration of a von Mises-Fisher density), `x = 0` the "
              "plain form",
          .printed = {{"lowest", "0"}, {"highest", "1"}},
          .inputs = {{"exponents", "0.001,0.1,0.5,1:15:1,25,100,1000,100000"}},
          .derivation =
              "c <= exp(c-1), so the plain form is never below c^k. Under every measure the cost falls when "
              "x grows from 0, so the best x is above 0. Blunt lobes: c^k = 1 + k log(c), a linear problem "
              "with x = slope k. Sharp lobes: x = limit + slope/k with t = k(1-c). Between them the largest "
              "x is searched for among the fits. x = 1 is not a least-squares fit: it gives the lobe its "
              "integral, 1/(k+1), up to exp(-(k+1)).",
          .figure = "offset",
          .source = sources::lagarde_2012},
    Claim{.id = "sg-plain-accurate",
          .statement =
              "`exp(k(c-1))` is accurate above `k = 15` and poor below 8; among the whole powers only "
              "`k = 1` and 2 are bad for every offset `x` of `exp((k+x)(c-1))`",
          .printed = {{"accurate above", "15"}, {"poor below", "8"}, {"bad up to", "2"}},
          .inputs = {{"offset", "0"},
                     {"accurate", "0.02"},
                     {"poor", "0.035"},
                     {"bad", "0.05"},
                     {"from", "0.1"},
                     {"to", "100000"}},
          .derivation =
              "The words are read as the largest absolute error over c in [0,1]: accurate at or below 0.02, "
              "poor above 0.035, bad above 0.05. At a fixed t = k(1-c) the plain form is e^(-t) for every k, "
              "and c^k = (1 - t/k)^k grows with k. So the error falls everywhere, and it crosses each "
              "threshold once. For large k it is 2/(e^2 k): e^(-t) t^2/(2k) at t = 2.",
          .figure = "lobe-errors",
          .source = sources::lagarde_2012},
    Claim{
        .id = "sg-plain-peak",
        .statement =
            "near the peak `exp(k(c-1))` is closer to `c^k` than `exp((k+x)(c-1))` with the published "
            "mean of `x`: above some cosine `c` that depends on `k`",
        .inputs = {{"offset", sg_offset_published[0].printed}, {"exponents", "1:15:1,25,50,100,1000,10000"}},
        .derivation =
            "Both errors are equal where 1 + exp(-x y) = 2 c^k/exp(-k y), y = 1-c. The logarithm of their "
            "ratio is convex in y; at the peak it is 0 and falls. So there is one crossing for every k. "
            "With t = k y it is at t = x - (2/3 + x/4) x^2/k + ..",
        .figure = "lobe-errors",
        .source = sources::lagarde_2012},
    Claim{
        .id = "sg-offset-one-low",
        .statement =
            "`exp((k+1)(c-1))` fits low specular powers nicely, and at high powers the +1 can be dropped",
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
            "Low powers are 3 to 15, for which the author's other post fits an offset. High powers are "
            "those above, where that post calls the plain form accurate. We read \"nicely\" as not poor: "
            "the largest absolute error over c in [0,1] is at most 0.035. We read \"can be dropped\" as: the two "
            "forms differ by less than 0.03. The difference of sharpness a < b has a closed form, "
            "(a/b)^(a/(b-a)) (b-a)/b. The post itself uses x = 1 at k = 5, for Fresnel.",
        .figure = "lobe-errors",
        .source = sources::lagarde_2011_adopting},
    Claim{.id = "sg-offset-matters-below",
          .statement =
              "from `k = 10` on the offsets `x = 0`, the published mean and 1 of `exp((k+x)(c-1))` differ "
              "subtly",
          .printed = {{"k", "10"}},
          .inputs = {{"plain", "0"},
                     {"fitted", sg_offset_published[0].printed},
                     {"literature", "1"},
                     {"subtle", "0.03"},
                     {"from", "0.1"},
                     {"to", "100000"}},
          .derivation =
              "Subtle: the curves differ by less than 0.03 anywhere. The largest difference of sharpness a < "
              "b is at y = log(b/a)/(b-a), where it is (a/b)^(a/(b-a)) (b-a)/b. At a fixed t = k(1-c) it "
              "falls as k grows; for large k it is (b-a)/(e k). So each pair has one threshold.",
          .figure = "lobe",
          .source = sources::lagarde_2012},
};

}  // namespace shadefit
