#pragma once

#include <array>

#include "approx/phong_blinn.hpp"
#include "approx/records/claim.hpp"
#include "approx/records/sources.hpp"

/// The rows of the ledger: Phong and Blinn.
namespace shadefit {

inline constexpr std::array phong_blinn_claims{
    Claim{
        .id = "phong-blinn-factor",
        .statement = "`cos^rho(theta) ~ cos^(x rho)(theta/2)` with `x = 4` (Fisher and Woo) or 4.2 (Gotanda)",
        .printed = {{"x of Fisher and Woo", phong_blinn_published[0].printed},
                    {"x of Gotanda", phong_blinn_published[1].printed}},
        .inputs = {{"from", "0"}, {"to", "1"}},
        .derivation =
            "Continuous least-squares fits, uniform in the cosine: the best x is 4 + 3/(2 rho) + "
            "O(1/rho^2), 4 for sharp lobes. The one-digit 4 is judged as that limit. 4.2 was published "
            "without an exponent, so it is right where the best x rounds to it.",
        .figure = "phong-blinn",
        .source = sources::lagarde_2012_phong_blinn,
        .constants = phong_blinn_published},
    Claim{.id = "phong-blinn-angle",
          .statement = "the Phong angle between `r` and `v` is twice the Blinn angle between `n` and `h`",
          .printed = {{"factor", "2"}},
          .inputs = {{"views", "30,60,80"}, {"step", "10"}, {"exponent", "32"}},
          .derivation =
              "In a plane r mirrors l, and h halves the angle between l and v: exactly 2. In space "
              "cos(phong) - cos(2 blinn) is the Gram determinant of n, l, v over 1 + l.v: the factor is "
              "below 2 wherever they are not coplanar. At the peak it is 2 along the plane of n and v and 2 "
              "n.v across. 2 blinn exceeds phong by at most 2 asin(1 - n.v), for a light on the horizon.",
          .source = sources::fisher_woo_1994},
};

}  // namespace shadefit
