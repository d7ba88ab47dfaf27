#pragma once

#include <array>
#include <tuple>
#include <type_traits>

#include "approx/lobe.hpp"
#include "approx/records/claim.hpp"
#include "approx/records/record.hpp"
#include "approx/records/sources.hpp"
#include "approx/scalar.hpp"

/// Normalisation constants of BRDFs and of the microfacet distribution, with view and normal aligned (v = n).
/// theta is the angle to the normal, y = 1 - cos(theta) in [0, 1], alpha > 0 the specular exponent. Each lobe
/// is written over y, where it keeps its digits at alpha = 1e6; over the hemisphere d omega = 2 pi dy.
///
/// With v = n the reflected view vector is n itself, so r.v = cos(theta), and the half vector bisects, so
/// n.h = cos(theta/2). A published constant is 1 over the lobe's integral.
namespace shadefit {

/// Lambert: n.l. alpha plays no part.
struct LambertLobe {
  static constexpr Normalisation record{"norm-lambert", "n.l", "1/pi", false, sources::lagarde_2011_adopting};
  static constexpr double sharpness = 0;  ///< the lobe falls at least as fast as exp(-sharpness alpha y)
  template <class T>
  static T lobe(const T& one_minus_cos, const T&) {
    return integer<T>(1) - one_minus_cos;
  }
  template <class T>
  static T constant(const T&) {
    return integer<T>(1) / pi<T>();
  }
};

/// Phong: (r.v)^a.
struct PhongLobe {
  static constexpr Normalisation record{"norm-phong", "(r.v)^a", "(a+1)/(2 pi)", true,
                                        sources::lagarde_2011_adopting};
  static constexpr double sharpness = 1;  ///< log(1-y) <= -y
  template <class T>
  static T lobe(const T& one_minus_cos, const T& alpha) {
    return power_lobe_near_peak(one_minus_cos, alpha);
  }
  template <class T>
  static T constant(const T& alpha) {
    return (alpha + integer<T>(1)) / (integer<T>(2) * pi<T>());
  }
};

/// Phong BRDF: (r.v)^a (n.l).
struct PhongBrdfLobe {
  static constexpr Normalisation record{"norm-phong-brdf", "(r.v)^a (n.l)", "(a+2)/(2 pi)", true,
                                        sources::lagarde_2011_adopting};
  static constexpr double sharpness = 1;
  template <class T>
  static T lobe(const T& one_minus_cos, const T& alpha) {
    return power_lobe_near_peak(one_minus_cos, alpha) * (integer<T>(1) - one_minus_cos);
  }
  template <class T>
  static T constant(const T& alpha) {
    return (alpha + integer<T>(2)) / (integer<T>(2) * pi<T>());
  }
};

/// Blinn-Phong: (n.h)^a.
struct BlinnPhongLobe {
  static constexpr Normalisation record{"norm-blinn-phong", "(n.h)^a", "(a+2)/(4 pi (2 - 2^(-a/2)))", true,
                                        sources::lagarde_2011_adopting};
  static constexpr double sharpness = 0.25;  ///< a/2 log(1-y/2) <= -a y/4
  template <class T>
  static T lobe(const T& one_minus_cos, const T& alpha) {
    return half_angle_power(one_minus_cos, alpha);
  }
  template <class T>
  static T constant(const T& alpha) {
    const T two = integer<T>(2);
    return (alpha + two) / (integer<T>(4) * pi<T>() * (two - exp2(-(alpha / two))));
  }
};

/// Blinn-Phong BRDF: (n.h)^a (n.l).
struct BlinnPhongBrdfLobe {
  static constexpr Normalisation record{"norm-blinn-phong-brdf", "(n.h)^a (n.l)",
                                        "(a+2)(a+4)/(8 pi (2^(-a/2) + a))", true,
                                        sources::lagarde_2011_adopting};
  static constexpr double sharpness = 0.25;
  template <class T>
  static T lobe(const T& one_minus_cos, const T& alpha) {
    return half_angle_power(one_minus_cos, alpha) * (integer<T>(1) - one_minus_cos);
  }
  template <class T>
  static T constant(const T& alpha) {
    const T two = integer<T>(2);
    return (alpha + two) * (alpha + integer<T>(4)) /
           (integer<T>(8) * pi<T>() * (exp2(-(alpha / two)) + alpha));
  }
};

/// The cheap stand-in for the constant of the Blinn-Phong BRDF: right in the limits a = 0 and infinity, and
/// too large by up to 7.5 % between them. Its source names it as given elsewhere, and quotes Naty Hoffman: "a
/// cheap approximation which is close to 1", that is with a reflectance close to 1, the more so for low
/// powers.
struct BlinnPhongCheapLobe {
  static constexpr Normalisation record{
      .id = "norm-blinn-phong-cheap",
      .lobe = "(n.h)^a (n.l)",
      .printed = "(a+8)/(8 pi)",
      .has_exponent = true,
      .source = sources::lagarde_2011_adopting,
      .closeness = 0.1};  // "close", which names no number, is read as: within a tenth
  static constexpr double sharpness = BlinnPhongBrdfLobe::sharpness;
  template <class T>
  static T lobe(const T& one_minus_cos, const T& alpha) {
    return BlinnPhongBrdfLobe::lobe(one_minus_cos, alpha);
  }
  template <class T>
  static T constant(const T& alpha) {
    const T eight = integer<T>(8);
    return (alpha + eight) / (eight * pi<T>());
  }
};

/// The microfacet distribution's own condition, D(m) (n.m) with D = (n.m)^a: an integral over the sphere of
/// microfacet normals, where D = 0 for n.m <= 0. The integrand is the Phong BRDF's, with m for l.
struct DistributionLobe {
  static constexpr Normalisation record{"norm-ndf", "D(m) (n.m), D = (n.m)^a", "(a+2)/(2 pi)", true,
                                        sources::lagarde_2011_adopting};
  static constexpr double sharpness = PhongBrdfLobe::sharpness;
  template <class T>
  static T lobe(const T& one_minus_cos, const T& alpha) {
    return PhongBrdfLobe::lobe(one_minus_cos, alpha);
  }
  template <class T>
  static T constant(const T& alpha) {
    return PhongBrdfLobe::constant(alpha);
  }
};

/// The microfacet BRDF D(h) / 4: a quarter of the distribution's constant, without an integral of its own, so
/// its lobe is 4 D(m) (n.m). In a game's light unit, which has absorbed pi, it is (a+2)/8.
struct MicrofacetLobe {
  static constexpr Normalisation record{"norm-microfacet", "4 D(m) (n.m), D = (n.m)^a", "(a+2)/(8 pi)", true,
                                        sources::lagarde_2011_adopting};
  static constexpr double sharpness = DistributionLobe::sharpness;
  template <class T>
  static T lobe(const T& one_minus_cos, const T& alpha) {
    return integer<T>(4) * DistributionLobe::lobe(one_minus_cos, alpha);
  }
  template <class T>
  static T constant(const T& alpha) {
    return DistributionLobe::constant(alpha) / integer<T>(4);
  }
};

/// Every lobe with its constant, in the order of the report.
using NormalisedLobes = std::tuple<LambertLobe, PhongLobe, PhongBrdfLobe, BlinnPhongLobe, BlinnPhongBrdfLobe,
                                   BlinnPhongCheapLobe, DistributionLobe, MicrofacetLobe>;

/// The records of all of them.
inline constexpr auto normalisations = []<class... Lobe>(std::type_identity<std::tuple<Lobe...>>) {
  return std::array{Lobe::record...};
}(std::type_identity<NormalisedLobes>{});

namespace detail {

/// What the rows on this topic are given: specular exponents for the view along the normal, and exponents and
/// view angles in degrees for the others.
inline constexpr Quantity normal_exponents{"exponents", "0.1,1,2,8,64,2048,100000,1000000"};
inline constexpr Quantity view_exponents{"exponents at other views", "1,64,2048"};
inline constexpr Quantity other_views{"view angles", "15:75:15,80,85,89,89.9"};

inline constexpr std::string_view reflectance_derivation =
    "With v = n the constant is 1 over the integral of the lobe over the hemisphere of lights, which Gauss-Kronrod "
    "over the cosine and tanh-sinh over the angle have to give alike. At the other views the lobe is cut by the "
    "horizon; there the reflectance, constant times integral (of the lobe as stated, and with n.l where the row has "
    "none), is taken in circles around the lobe's axis and again by longitude and latitude, and must not exceed 1.";

}  // namespace detail

/// The rows of the ledger on this topic. What is printed is a formula: it is read and evaluated, a = alpha.
inline constexpr std::array normalisation_claims{
    Claim{.id = LambertLobe::record.id,
          .statement = "Lambert's BRDF is normalised by 1/pi",
          .printed = {{"", LambertLobe::record.printed}},
          .derivation =
              "1 over the integral of n.l over the hemisphere of lights, 2 pi times that of c dc. It is the "
              "same at every view, as the lobe does not know the view.",
          .source = sources::lagarde_2011_adopting},
    Claim{.id = PhongLobe::record.id,
          .statement = "the Phong lobe (r.v)^a is normalised by (a+1)/(2 pi)",
          .printed = {{"", PhongLobe::record.printed}},
          .inputs = {detail::normal_exponents, detail::view_exponents, detail::other_views},
          .derivation = detail::reflectance_derivation,
          .source = sources::lagarde_2011_adopting},
    Claim{.id = PhongBrdfLobe::record.id,
          .statement = "the Phong BRDF with its cosine, (r.v)^a (n.l), is normalised by (a+2)/(2 pi)",
          .printed = {{"", PhongBrdfLobe::record.printed}},
          .inputs = {detail::normal_exponents, detail::view_exponents, detail::other_views},
          .derivation = detail::reflectance_derivation,
          .source = sources::lagarde_2011_adopting},
    Claim{.id = BlinnPhongLobe::record.id,
          .statement = "the Blinn-Phong lobe (n.h)^a is normalised by (a+2)/(4 pi (2 - 2^(-a/2)))",
          .printed = {{"", BlinnPhongLobe::record.printed}},
          .inputs = {detail::normal_exponents, detail::view_exponents, detail::other_views},
          .derivation = detail::reflectance_derivation,
          .source = sources::lagarde_2011_adopting},
    Claim{.id = BlinnPhongBrdfLobe::record.id,
          .statement =
              "the Blinn-Phong BRDF with its cosine, (n.h)^a (n.l), is normalised by (a+2)(a+4)/(8 pi "
              "(2^(-a/2) + a))",
          .printed = {{"", BlinnPhongBrdfLobe::record.printed}},
          .inputs = {detail::normal_exponents, detail::view_exponents, detail::other_views},
          .derivation = detail::reflectance_derivation,
          .source = sources::lagarde_2011_adopting},
    Claim{
        .id = BlinnPhongCheapLobe::record.id,
        .statement =
            "(a+8)/(8 pi) is a cheap stand-in for the constant of the Blinn-Phong BRDF with its cosine: its "
            "reflectance is close to 1, and closest at low powers a",
        .printed = {{"", BlinnPhongCheapLobe::record.printed}},
        .inputs = {{"close", "0.1"},
                   {"low power", "1"},
                   detail::normal_exponents,
                   {"exponents at other views", "1,8,64,2048"},
                   detail::other_views},
        .derivation =
            "Seen along the normal the reflectance is the ratio of the stand-in to the exact constant, which is 1 over the integral "
            "of the lobe by two rules; its largest distance from 1 is a root of its slope, looked for on a grid of an eighth of a "
            "power of two from 2^-10 to 2^20. Close is read as: within that input of 1 at every a. Closest at low powers is read as: "
            "the lower the power, the closer, at every a. At the other views the reflectance is the integral's, in circles around the "
            "lobe's axis; a stand-in above the exact constant sends up more than it receives.",
        .source = sources::lagarde_2011_adopting},
    Claim{
        .id = DistributionLobe::record.id,
        .statement =
            "the Blinn-Phong distribution D(m) = (n.m)^a is normalised by (a+2)/(2 pi): the integral of D(m) "
            "(n.m) over the sphere of microfacet normals m is 1",
        .printed = {{"", DistributionLobe::record.printed}},
        .inputs = {detail::normal_exponents},
        .derivation =
            "D = 0 for n.m <= 0, so the sphere is the hemisphere, and the constant is 1 over the integral "
            "of (n.m)^(a+1), by two rules. As D is the same all around n, its mean normal lies along n, "
            "and the signed projected area from any v is v.n times this integral.",
        .source = sources::lagarde_2011_adopting},
    Claim{
        .id = MicrofacetLobe::record.id,
        .statement =
            "the microfacet BRDF with the Blinn-Phong distribution has the constant (a+2)/(8 pi), a quarter "
            "of the distribution's; in a game's light unit, in which pi drops out, (a+2)/8",
        .printed = {{"", MicrofacetLobe::record.printed}, {"in a game's light unit", "(a+2)/8"}},
        .inputs = {detail::normal_exponents, {"light unit", "pi"}},
        .derivation =
            "The quarter is the 1/(4 (n.l) (n.v)) of a microfacet BRDF, whose cosines the visibility term "
            "takes. It has no integral of its own: it is held against 1 over that of 4 D(m) (n.m), by two "
            "rules. A game multiplies the light by pi, and so the second number is that times the light "
            "unit.",
        .source = sources::lagarde_2011_adopting},
    Claim{
        .id = "norm-game-light-unit",
        .statement =
            "a light whose brightness is multiplied by pi cancels the 1/pi of Lambert's BRDF: pi (c_diff/pi) "
            "= c_diff, so that a game shades with c_diff alone",
        .inputs = {{"with pi", "pi (c_diff/pi)"}, {"without", "c_diff"}},
        .derivation =
            "Both sides are linear in c_diff, so they agree everywhere if they do at two values; all 255 "
            "grey levels are tried, in 50 digits. What the detour by pi costs is counted in half "
            "precision.",
        .source = sources::lagarde_2012_pi},
};

}  // namespace shadefit
