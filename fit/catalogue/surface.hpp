#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "approx/fresnel.hpp"
#include "approx/scalar.hpp"

/// The target of a Fresnel form: Schlick's formula or the exact one, with or without a named surface.
namespace shadefit {

/// A smooth surface and the formula of its reflectance.
struct Surface {
  enum class Formula { schlick, exact };

  Formula formula = Formula::schlick;
  double ior = 0;         ///< index of refraction, behind over in front; 0: no surface is named
  double extinction = 0;  ///< 0: a dielectric; above: a conductor
  /// Without a named surface: the reflectance at normal incidence for relative errors. Empty: the
  /// `reference_f0`.
  std::optional<double> f0 = std::nullopt;

  bool is_named() const { return ior != 0; }
  bool is_exact() const { return formula == Formula::exact; }
};

/// The exact formula for an index of refraction and an extinction.
constexpr Surface exact_surface(double ior, double extinction = 0) {
  return {Surface::Formula::exact, ior, extinction, std::nullopt};
}

/// Schlick's formula for the same surface.
constexpr Surface schlick_surface(double ior, double extinction = 0) {
  return {Surface::Formula::schlick, ior, extinction, std::nullopt};
}

/// The reflectance at normal incidence; without a named surface, `f0`.
inline double normal_reflectance(const Surface& surface) {
  if (!surface.is_named()) return surface.f0 ? *surface.f0 : constant<double>(reference_f0);
  if (surface.extinction == 0) return reflectance_at_normal(surface.ior);
  return conductor_reflectance_at_normal(surface.ior, surface.extinction);
}

/// The weight of the reflectance between f0 and 1 at the cosine c: (F - f0)/(1 - f0).
inline double target_weight(const Surface& surface, double cos_theta) {
  if (!surface.is_exact()) return schlick_weight(cos_theta);
  const double reflectance = surface.extinction == 0
                                 ? dielectric_reflectance(cos_theta, surface.ior)
                                 : conductor_reflectance(cos_theta, surface.ior, surface.extinction);
  return weight_of_reflectance(reflectance, normal_reflectance(surface));
}

/// The scale of the target: the cosine at which its weight first falls to one half, on the way from grazing
/// (c = 0) to normal incidence. For Schlick's formula this is 1 - 2^(-1/5); a metal may lose its grazing
/// reflectance within a hundredth. It is rounded to a power of 2^(1/4), which is near enough.
inline double half_weight_cosine(const Surface& surface) {
  double c = std::ldexp(1.0, -40);
  while (c < 1 && target_weight(surface, c) > 0.5) c *= std::exp2(0.25);
  return std::min(c, 1.0);
}

/// The place that cuts the domain of an exact target that falls within a small part of it: eight times the
/// cosine at which it has fallen to one half. Then the fall and the rest have their own nodes. From inside a
/// dielectric the target has a kink, which is found as such.
inline std::optional<double> end_of_fall(const Surface& surface) {
  const bool has_kink = surface.extinction == 0 && surface.ior < 1;
  if (!surface.is_exact() || has_kink) return std::nullopt;
  const double end = 8 * half_weight_cosine(surface);
  return end < 0.6 ? std::optional(end) : std::nullopt;
}

}  // namespace shadefit
