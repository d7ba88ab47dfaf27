#pragma once

#include <array>
#include <tuple>
#include <type_traits>

#include "approx/lobe.hpp"
#include "approx/record.hpp"
#include "approx/scalar.hpp"
#include "approx/sources.hpp"

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

/// Every lobe with its constant, in the order of the report.
using NormalisedLobes =
    std::tuple<LambertLobe, PhongLobe, PhongBrdfLobe, BlinnPhongLobe, BlinnPhongBrdfLobe, DistributionLobe>;

/// The records of all of them.
inline constexpr auto normalisations = []<class... Lobe>(std::type_identity<std::tuple<Lobe...>>) {
  return std::array{Lobe::record...};
}(std::type_identity<NormalisedLobes>{});

}  // namespace shadefit
