#pragma once

#include <array>
#include <string_view>

#include "approx/records/claim.hpp"
#include "approx/records/sources.hpp"

/// The rows of the ledger: Microfacet distributions.
namespace shadefit {

namespace detail {

/// Inputs of the rows on this topic: roughnesses r, and the formula that gives a width.
inline constexpr Quantity roughnesses{"roughness", "0.01,0.05,0.1,0.3,0.5,0.7,0.9,1"};
inline constexpr Quantity width_of_roughness{"alpha", "r^2"};
/// View angles in degrees.
inline constexpr Quantity masking_views{"view angles", "15:75:15,85,89,89.9"};

inline constexpr std::string_view masking_derivation =
    "The microfacets visible from v fill exactly the visible part of the surface. G1 = 1/(1 + Lambda) is "
    "the same for every m that faces v, so the integral is G1 times that of D(m) max(v.m, 0); over the "
    "azimuth of m it is in closed form, 2 (p phi + q sin phi) with p = cos(theta_v) cos, q = sin(theta_v) "
    "sin up to the phi at which v.m = 0, and over the polar angle it is taken by Gauss-Kronrod in the "
    "logarithm of the slope and by tanh-sinh in sine and cosine.";

}  // namespace detail

inline constexpr std::array microfacet_claims{
    Claim{.id = "ndf-blinn-phong",
          .statement =
              "`1/(pi alpha^2)` `(n.m)^(2/alpha^2 - 2)`, the Blinn-Phong distribution with Beckmann's width "
              "`alpha`: the integral of `D(m) (n.m)` over the microfacet normals `m` is 1",
          .printed = {{"", "1"}},
          .inputs = {detail::roughnesses, detail::width_of_roughness},
          .derivation =
              "The microfacets' projected areas add up to the surface's. With s = 2/alpha^2 - 2 the factor "
              "is (s+2)/(2 pi), that of the row norm-ndf. The integral is taken by Gauss-Kronrod over the "
              "logarithm of the slope tan, in which the lobe keeps its width at every roughness, and by "
              "tanh-sinh over sine and cosine.",
          .source = sources::karis_2013},
    Claim{.id = "ndf-beckmann",
          .statement =
              "`exp(-tan^2/alpha^2)/(pi alpha^2 cos^4)`, Beckmann's distribution, angles between `m` and "
              "`n`: the integral of `D(m) (n.m)` over the microfacet normals `m` is 1",
          .printed = {{"", "1"}},
          .inputs = {detail::roughnesses, detail::width_of_roughness},
          .derivation =
              "The microfacets' projected areas add up to the surface's; in t = tan^2 the integral is that "
              "of exp(-t/alpha^2)/alpha^2. It is taken by Gauss-Kronrod over the logarithm of the slope, in "
              "which the lobe keeps its width at every roughness, and by tanh-sinh over sine and cosine.",
          .source = sources::walter_2007},
    Claim{.id = "ndf-ggx",
          .statement =
              "`alpha^2/(pi ((n.m)^2 (alpha^2 - 1) + 1)^2)`, GGX (Trowbridge-Reitz): the integral of "
              "`D(m) (n.m)` over the microfacet normals `m` is 1",
          .printed = {{"", "1"}},
          .inputs = {detail::roughnesses, detail::width_of_roughness},
          .derivation =
              "The microfacets' projected areas add up to the surface's; in u = sin^2 the integral is that "
              "of alpha^2/(alpha^2 + (1 - alpha^2) u)^2. It is taken by Gauss-Kronrod over the logarithm of "
              "the slope, in which the lobe keeps its width at every roughness, and by tanh-sinh over sine "
              "and cosine.",
          .source = sources::walter_2007},
    Claim{.id = "ndf-gtr1",
          .statement =
              "`(alpha^2 - 1)/(pi log(alpha^2)) / (1 + (alpha^2 - 1)(n.m)^2)`, generalised Trowbridge-Reitz "
              "of exponent 1: the integral of `D(m) (n.m)` over the microfacet normals `m` is 1, and at "
              "`alpha = 1`, where the formula is `0/0`, `D` is its limit `1/pi`",
          .printed = {{"integral", "1"}, {"limit", "1/pi"}},
          .inputs = {detail::roughnesses, detail::width_of_roughness, {"distance from alpha = 1", "1e-10"}},
          .derivation =
              "The microfacets' projected areas add up to the surface's; in u = sin^2 the integral is that "
              "of 1/(alpha^2 + (1 - alpha^2) u), a logarithm. It is taken by Gauss-Kronrod over the "
              "logarithm of the slope and by tanh-sinh over sine and cosine. With alpha = 1 + h, D is 1/pi "
              "times 1 + h - 2 h (n.m)^2 + O(h^2): at most |h| from 1/pi, which 50 digits on both sides of "
              "alpha = 1 have to show.",
          .source = sources::burley_2012},
    Claim{.id = "smith-beckmann",
          .statement =
              "Beckmann's distribution with Smith's `G1` of its own `Lambda`, "
              "`(erf(a) - 1)/2 + exp(-a^2)/(2 a sqrt(pi))`, `a = 1/(alpha tan(theta_v))`: the integral of "
              "`G1 D(m) max(v.m, 0)` is `v.n` for every view `v`",
          .inputs = {{"distribution", "beckmann"},
                     {"masking", "beckmann"},
                     detail::roughnesses,
                     detail::width_of_roughness,
                     detail::masking_views},
          .derivation = detail::masking_derivation,
          .source = sources::heitz_2014},
    Claim{.id = "smith-ggx",
          .statement =
              "GGX with Smith's `G1` of its own `Lambda`, `(sqrt(1 + alpha^2 tan^2(theta_v)) - 1)/2`: the "
              "integral of `G1 D(m) max(v.m, 0)` is `v.n` for every view `v`",
          .inputs = {{"distribution", "ggx"},
                     {"masking", "ggx"},
                     detail::roughnesses,
                     detail::width_of_roughness,
                     detail::masking_views},
          .derivation = detail::masking_derivation,
          .source = sources::heitz_2014},
    Claim{.id = "smith-borrowed",
          .statement =
              "Blinn-Phong is commonly combined with Beckmann's `G1`, and GTR1 with GGX's. We test a claim "
              "of ours: the integral of `G1 D(m) max(v.m, 0)` is still `v.n`, to within 2 %",
          .inputs = {{"blinn-phong", "beckmann"},
                     {"gtr1", "ggx"},
                     detail::roughnesses,
                     detail::width_of_roughness,
                     detail::masking_views,
                     {"accurate", "0.02"}},
          .derivation =
              "The integral is that of smith-beckmann and smith-ggx. Walter et al. 2007 lend Beckmann's G1 "
              "to the Phong distribution with a = sqrt(s/2 + 1)/tan(theta_v), which is 1/(alpha "
              "tan(theta_v)) for s = 2/alpha^2 - 2; Burley 2012 masks GTR1 by GGX's G1, there at a fixed "
              "width, here at GTR1's own. In the first case both lobes agree up to relative O(alpha^2), so "
              "it is good at low roughness. GTR1 has longer tails than GGX, and a grazing view sees mostly "
              "the tails: GGX's G1 hides too little of them. At alpha = 1 GTR1 is GGX. We read \"accurate\" "
              "as: the integral is within that relative distance of v.n.",
          .source = sources::walter_2007},
};

}  // namespace shadefit
