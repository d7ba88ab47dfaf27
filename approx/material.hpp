#pragma once

#include <string_view>

#include "approx/scalar.hpp"

/// Materials: colour charts, metals and dielectrics, and the energy that a workflow keeps. Colours, albedos
/// and reflectances are linear, one channel, in [0, 1].
namespace shadefit {

/// The albedo of the metallic workflow: c - c m, for the base colour c and metallic m in [0, 1].
/// Source: Pestana 2014, "Physically Based Shading, Metallic and Specular workflows".
template <class T>
T metallic_albedo(const T& base_colour, const T& metallic) {
  return base_colour - base_colour * metallic;
}

/// The reflectance at normal incidence of the metallic workflow: linear from the common value of all
/// dielectrics (m = 0) to the base colour c (m = 1). Source: as above.
template <class T>
T metallic_f0(const T& dielectric_f0, const T& base_colour, const T& metallic) {
  return dielectric_f0 + metallic * (base_colour - dielectric_f0);
}

/// The brightest base colour that keeps albedo + F0 <= 1: their sum is c (1-m) + f0 (1-m) + c m = c + f0
/// (1-m), so 1 - f0 (1-m).
template <class T>
T brightest_base_colour(const T& dielectric_f0, const T& metallic) {
  const T one = integer<T>(1);
  return one - dielectric_f0 * (one - metallic);
}

/// The mean of Schlick's F = f0 + (1-f0)(1-c)^5 over a hemisphere of uniform light, weighted by the cosine:
/// the integral of (1-c)^5 2c dc is 2 B(2, 6) = 2 * 1! 5!/7! = 1/21, so f0 + (1-f0)/21.
template <class T>
T mean_schlick_reflectance(const T& f0) {
  return f0 + (integer<T>(1) - f0) / integer<T>(21);
}

// Factors for a Lambertian term under a mirror-like surface, so that the sum reflects no more than comes in.
// F_i and F_o are the surface's reflectances towards the light and the view, f0 its reflectance at normal
// incidence. The names are those of the records.

/// (1-F_i)(1-F_o): the transmittance in times the transmittance out. Reciprocal.
/// Source: Shirley, Smits, Hu, Lafortune 1997, "A Practitioners' Assessment of Light Reflection Models".
struct TransmittedBothWays {
  static constexpr std::string_view name = "(1-F_i)(1-F_o)";
  template <class T>
  static T factor(const T& f_in, const T& f_out, const T&) {
    return (integer<T>(1) - f_in) * (integer<T>(1) - f_out);
  }
};

/// 1-F_i: the transmittance in. Not reciprocal.
struct TransmittedIn {
  static constexpr std::string_view name = "1-F_i";
  template <class T>
  static T factor(const T& f_in, const T&, const T&) {
    return integer<T>(1) - f_in;
  }
};

/// 1-F0: the transmittance at normal incidence. Reciprocal, and costs nothing.
struct TransmittedAtNormal {
  static constexpr std::string_view name = "1-F0";
  template <class T>
  static T factor(const T&, const T&, const T& f0) {
    return integer<T>(1) - f0;
  }
};

/// 1: ignores the surface.
struct Unattenuated {
  static constexpr std::string_view name = "1";
  template <class T>
  static T factor(const T&, const T&, const T&) {
    return integer<T>(1);
  }
};

}  // namespace shadefit
