#pragma once

#include <array>
#include <tuple>
#include <type_traits>

#include "approx/lobe.hpp"
#include "approx/records/record.hpp"
#include "approx/records/sources.hpp"
#include "approx/scalar.hpp"

/// Normalisation constants of BRDFs and of the microfacet distribution, with view and normal aligned (v = n).
/// theta is the angle to the normal, y = 1 - cos(theta) in [0, 1], alpha > 0 the specular exponent. Each lobe
/// is a function of y, so it keeps its digits at alpha = 1e6. Over the hemisphere d omega = 2 pi dy.
///
/// With v = n the reflected view vector is n, so r.v = cos(theta). The half vector bisects the angle, so n.h
/// = cos(theta/2). A published constant is 1 over the lobe's integral.
namespace shadefit {

/// Lambert: n.l. It does not use alpha.
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

/// A cheap approximation of the constant of the Blinn-Phong BRDF: exact in the limits a = 0 and infinity, and
/// up to 7.5 % too large between them. Its source cites it from elsewhere and quotes Naty Hoffman: "a cheap
/// approximation which is close to 1". This means a reflectance close to 1, especially for low powers.
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

/// The microfacet BRDF D(h) / 4. It has no integral of its own; its constant is a quarter of the
/// distribution's, so its lobe is 4 D(m) (n.m). In a game's light unit, which absorbs pi, the constant is
/// (a+2)/8.
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

inline constexpr auto normalisations = []<class... Lobe>(std::type_identity<std::tuple<Lobe...>>) {
  return std::array{Lobe::record...};
}(std::type_identity<NormalisedLobes>{});

}  // namespace shadefit
