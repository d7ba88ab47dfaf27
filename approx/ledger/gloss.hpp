#pragma once

#include <array>

#include "approx/records/claim.hpp"
#include "approx/records/sources.hpp"

/// The rows of the ledger: Gloss and logarithms.
namespace shadefit {

inline constexpr std::array gloss_claims{
    Claim{.id = "gloss-log2-constant",
          .statement = "the constant `1 + log2(1/ln 2)` that decodes a gloss `g` to "
                       "`M = s/ln 2 = 2^(10 g + constant)`",
          .printed = {{"", "1.528766"}},
          .inputs = {{"doublings", "10"}, {"first", "1"}, {"from", "0"}, {"to", "1"}, {"steps", "16"}},
          .derivation =
              "s/ln 2 = 2^(10 g + 1) 2^(log2(1/ln 2)). At 50 digits, log2 once by the natural logarithm and "
              "once by squaring, one binary digit a step. A constant that is off by d multiplies every power "
              "by 2^d, whatever the gloss.",
          .source = sources::lagarde_2012},
    Claim{.id = "gloss-ln2-over-8",
          .statement =
              "`ln 2/8`, the factor of `M` in the normalisation `(s+2)/8 = M ln 2/8 + 1/4`, `M = s/ln 2`",
          .printed = {{"", "0.08664"}},
          .inputs = {{"doublings", "10"}, {"first", "1"}, {"from", "0"}, {"to", "1"}, {"steps", "16"}},
          .derivation =
              "At 50 digits, log(2) once as the constant and once as the binary logarithm of e by squaring, "
              "inverted. The relative error of the normalisation grows with s/(s+2).",
          .source = sources::lagarde_2012},
    Claim{.id = "gloss-decode",
          .statement = "`s = 2^(10 g + 1)` maps a gloss `g in [0,1]` to specular powers 2 to 2048",
          .printed = {{"lowest", "2"}, {"highest", "2048"}},
          .inputs = {{"doublings", "10"}, {"first", "1"}, {"from", "0"}, {"to", "1"}, {"levels", "256"}},
          .derivation =
              "It rises with g, so its range is from one end to the other: whole powers of two, exact in "
              "float and half alike. Each of the 255 steps of an 8-bit gloss multiplies the power by "
              "2^(10/255).",
          .source = sources::lagarde_2011_adopting},
    Claim{.id = "exp2-identity",
          .statement = "`exp(a) = exp2(a/ln 2)`",
          .inputs = {{"from", "-1000"}, {"to", "1000"}, {"steps", "40"}, {"agreement", "1e-45"}},
          .derivation =
              "e = 2^(1/ln 2). Both sides at 50 digits: e^a by its series, 2^x without any logarithm, as a "
              "product with one factor for each binary digit 1 of x: sqrt(2) for 1/2, its root for 1/4, and "
              "so on. Rounding "
              "leaves |a| times 1e-50, hence the bound. The exponents are those that an SG of power 1000 "
              "meets.",
          .source = sources::lagarde_2012},
    Claim{.id = "gloss-normalised-mad",
          .statement = "`(s+2)/8 = M*0.08664 + 0.25` for `M = s/ln 2`: the normalisation is one multiply-add",
          .inputs = {{"factor", "0.08664"},
                     {"constant", "0.25"},
                     {"doublings", "10"},
                     {"first", "1"},
                     {"from", "0"},
                     {"to", "1"},
                     {"steps", "16"},
                     {"agreement", "1e-45"}},
          .derivation =
              "M ln 2 = s. The identity is judged with the closed form ln 2/8 as its factor, to which the "
              "printed factor has to round, and with the constant as printed. The effect is that of the "
              "printed factor. Both sides, at 50 digits, differ only by rounding, hence the bound.",
          .source = sources::lagarde_2012},
    Claim{.id = "log2-identity-first",
          .statement = "the first version of the post: `log(a) = log2(a*log(2))`",
          .inputs = {{"from", "-20"}, {"to", "20"}, {"steps", "40"}, {"agreement", "1e-45"}},
          .derivation =
              "a = 2^u, u from -20 to 20. log2(a ln 2) - log(a) = (1 - ln 2) u + log2(ln 2), which is 0 for "
              "one u only, so it is not an identity. The product belongs outside the logarithm: log(a) = "
              "log(2)*log2(a).",
          .source = sources::lagarde_2012_first},
    Claim{.id = "log2-identity-second",
          .statement = "the second version of the post: `log(a) = log(2)*log2(a)`",
          .inputs = {{"from", "-20"}, {"to", "20"}, {"steps", "40"}, {"agreement", "1e-45"}},
          .derivation =
              "a = 2^u, u from -20 to 20, and a third of it, so that not every logarithm is whole. log2 at "
              "50 digits by squaring, one binary digit a step, and log by its own series: rounding leaves "
              "about |log(a)| times 1e-50, hence the bound.",
          .source = sources::lagarde_2012},
};

}  // namespace shadefit
