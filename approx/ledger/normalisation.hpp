#pragma once

#include <array>
#include <string_view>

#include "approx/normalisation.hpp"
#include "approx/records/claim.hpp"
#include "approx/records/sources.hpp"

/// The rows of the ledger: Normalisation.
namespace shadefit {

namespace detail {

/// Inputs of the rows on this topic: specular exponents for the view along the normal; exponents and view
/// angles in degrees for the others.
inline constexpr Quantity normal_exponents{"exponents", "0.1,1,2,8,64,2048,100000,1000000"};
inline constexpr Quantity view_exponents{"exponents at other views", "1,64,2048"};
inline constexpr Quantity other_views{"view angles", "15:75:15,80,85,89,89.9"};

inline constexpr std::string_view reflectance_derivation =
    "With v = n the constant is 1 over the integral of the lobe over the hemisphere of lights, which "
    "Gauss-Kronrod over the cosine and tanh-sinh over the angle have to give alike. At the other views the "
    "lobe is cut by the horizon; there the reflectance, constant times integral (of the lobe as stated, "
    "and with n.l where the row has none), is taken in circles around the lobe's axis and again by "
    "longitude and latitude, and must not exceed 1.";

}  // namespace detail

/// The printed values are formulas, which are parsed and evaluated; a = alpha.
inline constexpr std::array normalisation_claims{
    Claim{.id = LambertLobe::record.id,
          .statement = "Lambert's BRDF is normalised by `1/pi`",
          .printed = {{"", LambertLobe::record.printed}},
          .derivation =
              "1 over the integral of n.l over the hemisphere of lights, 2 pi times that of c dc. It is the "
              "same for every view, as the lobe does not depend on the view.",
          .source = sources::lagarde_2011_adopting},
    Claim{.id = PhongLobe::record.id,
          .statement = "the Phong lobe `(r.v)^a` is normalised by `(a+1)/(2 pi)`",
          .printed = {{"", PhongLobe::record.printed}},
          .inputs = {detail::normal_exponents, detail::view_exponents, detail::other_views},
          .derivation = detail::reflectance_derivation,
          .source = sources::lagarde_2011_adopting},
    Claim{.id = PhongBrdfLobe::record.id,
          .statement = "the Phong BRDF with its cosine, `(r.v)^a (n.l)`, is normalised by `(a+2)/(2 pi)`",
          .printed = {{"", PhongBrdfLobe::record.printed}},
          .inputs = {detail::normal_exponents, detail::view_exponents, detail::other_views},
          .derivation = detail::reflectance_derivation,
          .source = sources::lagarde_2011_adopting},
    Claim{.id = BlinnPhongLobe::record.id,
          .statement = "the Blinn-Phong lobe `(n.h)^a` is normalised by `(a+2)/(4 pi (2 - 2^(-a/2)))`",
          .printed = {{"", BlinnPhongLobe::record.printed}},
          .inputs = {detail::normal_exponents, detail::view_exponents, detail::other_views},
          .derivation = detail::reflectance_derivation,
          .source = sources::lagarde_2011_adopting},
    Claim{.id = BlinnPhongBrdfLobe::record.id,
          .statement = "the Blinn-Phong BRDF with its cosine, `(n.h)^a (n.l)`, is normalised by "
                       "`(a+2)(a+4)/(8 pi (2^(-a/2) + a))`",
          .printed = {{"", BlinnPhongBrdfLobe::record.printed}},
          .inputs = {detail::normal_exponents, detail::view_exponents, detail::other_views},
          .derivation = detail::reflectance_derivation,
          .source = sources::lagarde_2011_adopting},
    Claim{.id = BlinnPhongCheapLobe::record.id,
          .statement =
              "`(a+8)/(8 pi)` is a cheap stand-in for the constant of the Blinn-Phong BRDF with its cosine: "
              "its reflectance is close to 1, and closest at low powers `a`",
          .printed = {{"", BlinnPhongCheapLobe::record.printed}},
          .inputs = {{"close", "0.1"},
                     {"low power", "1"},
                     detail::normal_exponents,
                     {"exponents at other views", "1,8,64,2048"},
                     detail::other_views},
          .derivation =
              "Seen along the normal the reflectance is the ratio of the stand-in to the exact constant, "
              "which is 1 over the integral of the lobe by two rules; its largest distance from 1 is a root "
              "of its slope, looked for on a grid of an eighth of a power of two from 2^-10 to 2^20. We "
              "read \"close\" as: within that input of 1 at every a; \"closest at low powers\" as: the lower "
              "the power, the closer, at every a. At the other views the reflectance is the integral's, in "
              "circles around the lobe's axis; a stand-in above the exact constant reflects more than it "
              "receives.",
          .source = sources::lagarde_2011_adopting},
    Claim{.id = DistributionLobe::record.id,
          .statement =
              "the Blinn-Phong distribution `D(m) = (n.m)^a` is normalised by `(a+2)/(2 pi)`: the integral "
              "of `D(m) (n.m)` over the sphere of microfacet normals `m` is 1",
          .printed = {{"", DistributionLobe::record.printed}},
          .inputs = {detail::normal_exponents},
          .derivation =
              "D = 0 for n.m <= 0, so the sphere is the hemisphere, and the constant is 1 over the integral "
              "of (n.m)^(a+1), by two rules. As D is the same all around n, its mean normal lies along n, "
              "and the signed projected area from any v is v.n times this integral.",
          .source = sources::lagarde_2011_adopting},
    Claim{.id = MicrofacetLobe::record.id,
          .statement =
              "the microfacet BRDF with the Blinn-Phong distribution has the constant `(a+2)/(8 pi)`, a "
              "quarter of the distribution's; in a game, which multiplies the light by `pi`, it is `(a+2)/8`",
          .printed = {{"", MicrofacetLobe::record.printed}, {"in a game's light unit", "(a+2)/8"}},
          .inputs = {detail::normal_exponents, {"light unit", "pi"}},
          .derivation =
              "The quarter is the 1/(4 (n.l) (n.v)) of a microfacet BRDF, whose cosines the visibility term "
              "takes. It has no integral of its own. It is compared with 1 over the integral of 4 D(m) "
              "(n.m), by two rules. A game multiplies the light by pi, so the second number is pi times the "
              "first.",
          .source = sources::lagarde_2011_adopting},
    Claim{.id = "norm-game-light-unit",
          .statement = "a light whose brightness is multiplied by `pi` cancels the `1/pi` of Lambert's BRDF: "
                       "`pi (c_diff/pi) = c_diff`, so that a game shades with `c_diff` alone",
          .inputs = {{"with pi", "pi (c_diff/pi)"}, {"without", "c_diff"}},
          .derivation =
              "Both sides are linear in c_diff, so they agree everywhere if they do at two values; all 255 "
              "grey levels are tried, in 50 digits. The cost of the detour by pi is measured in half "
              "precision.",
          .source = sources::lagarde_2012_pi},
};

}  // namespace shadefit
