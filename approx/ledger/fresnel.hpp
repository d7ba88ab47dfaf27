#pragma once

#include <array>
#include <span>

#include "approx/fresnel.hpp"
#include "approx/lobe.hpp"
#include "approx/records/claim.hpp"
#include "approx/records/sources.hpp"

/// The rows of the ledger: Fresnel.
namespace shadefit {

inline constexpr std::array fresnel_claims{
    Claim{.id = "fresnel-one-term",
          .statement =
              "`(1-c)^5 ~ exp2(-A c)`, by the lobe of exponent 5 with its best offset `x`: `A = (5+x)/ln 2`",
          .printed = {{"A", fresnel_published[0].printed}},
          .inputs = {{"x", sg_offset_published[2].printed}, {"from", "0"}, {"to", "1"}},
          .derivation =
              "A continuous least-squares fit of A, uniform in the cosine; c -> 1-c makes it the fit of the "
              "lobe c^5. The closed form from the printed x is judged too. Both have to give the printed "
              "digits.",
          .figure = "fresnel",
          .source = sources::lagarde_2012,
          .constants = std::span(&fresnel_published[0], 1)},
    Claim{.id = "fresnel-one-term-at-1",
          .statement = "`exp2(-A c)` at `c = 1`, where `(1-c)^5` is 0",
          .printed = {{"", "0.003"}},
          .inputs = {{"A", fresnel_published[0].printed}, {"f0", reference_f0}},
          .derivation =
              "exp2(-A) of the printed A. It remains in F = f0 + (1-f0) f at normal incidence, where F "
              "should be f0.",
          .figure = "fresnel",
          .source = sources::lagarde_2012},
    Claim{.id = "fresnel-quadratic",
          .statement = "`(1-c)^5 ~ exp2((a c + b) c)`",
          .printed = {{"a", fresnel_published[2].printed}, {"b", fresnel_published[3].printed}},
          .inputs = {{"from", "0"}, {"to", "1"}},
          .derivation = "A continuous least-squares fit of both coefficients, uniform in the cosine.",
          .figure = "fresnel-errors",
          .source = sources::lagarde_2012,
          .constants = std::span(&fresnel_published[2], 2)},
    Claim{.id = "fresnel-quadratic-at-1",
          .statement = "`exp2((a c + b) c)` at `c = 1`, and how many times smaller that is than `exp2(-A)`",
          .printed = {{"value", "0.000168"}, {"ratio", "17"}},
          .inputs = {{"a", fresnel_published[2].printed},
                     {"b", fresnel_published[3].printed},
                     {"A", fresnel_published[0].printed},
                     {"exp2(-A) as printed", "0.003"},
                     {"f0", reference_f0}},
          .derivation =
              "exp2(a + b) of the printed pair, and exp2(-A) over it. The quotient of the two values as "
              "printed is shown too: their few digits change it.",
          .figure = "fresnel",
          .source = sources::lagarde_2012},
    Claim{
        .id = "fresnel-offset-one",
        .statement = "`(1-c)^5 ~ exp2(-A c)` with the offset `x = 1`: `A = 6/ln 2`",
        .printed = {{"A", fresnel_published[1].printed}},
        .inputs = {{"from", "0"}, {"to", "1"}},
        .derivation = "No fit gives this A under the measures here; the closed form of the convention does.",
        .figure = "fresnel-errors",
        .source = sources::lagarde_2011_adopting,
        .constants = std::span(&fresnel_published[1], 1)},
    Claim{.id = "fresnel-power-four",
          .statement = "`(1-c)^4` is a worse stand-in for `(1-c)^5` than `exp2(-A c)`",
          .inputs = {{"power", "4"}, {"A", fresnel_published[0].printed}, {"f0", reference_f0}},
          .derivation =
              "Five readings of worse: the root mean square of the error under each measure, its largest "
              "magnitude, and the largest relative error of F = f0 + (1-f0) f. (1-c)^4 - (1-c)^5 = c (1-c)^4 "
              "is largest at c = 1/5, where it is 256/3125.",
          .figure = "fresnel-errors",
          .source = sources::lagarde_2012},
    Claim{.id = "fresnel-relative-error",
          .statement =
              "a reader plots the relative error of `F = f0 + (1-f0) f` at `f0 = 0.04`: with "
              "`f = exp2((a c + b) c)` it is far smaller than with `f = exp2(-A c)`, `A` of the offset 1",
          .inputs = {{"a", fresnel_published[2].printed},
                     {"b", fresnel_published[3].printed},
                     {"A", fresnel_published[1].printed},
                     {"f0", reference_f0},
                     {"far smaller", "0.5"}},
          .derivation =
              "The largest relative error of each over c in [0, 1], at the roots of its derivative. We "
              "read \"far smaller\" as: at most half as large.",
          .figure = "fresnel-errors",
          .source = sources::lagarde_2012},
    Claim{.id = "fresnel-exponent-sum",
          .statement = "the exponent `(a c + b) c` at `c = 1`",
          .printed = {{"", "-12.53789"}},
          .inputs = {{"a", fresnel_published[2].printed}, {"b", fresnel_published[3].printed}},
          .derivation = "a + b of the printed pair, in decimal. The unrounded optimum is shown too.",
          .source = sources::lagarde_2012},
    Claim{.id = "fresnel-roughness",
          .statement =
              "`F = f0 + (max(g, f0) - f0)(1-c)^5` stays within `[f0, max(g, f0)]` for `f0` and the gloss "
              "`g in [0, 1]`",
          .inputs = {{"from", "0"}, {"to", "1"}, {"steps", "255"}},
          .derivation =
              "With w = (1-c)^5, F - f0 = (m - f0) w and m - F = (m - f0)(1 - w), m = max(g, f0) >= f0: "
              "neither is negative while w is in [0, 1]. w falls with c, so the ends of the range of c are "
              "its extremes; F is computed there for all f0 and g in equal steps.",
          .source = sources::lagarde_2011_adopting},
};

}  // namespace shadefit
