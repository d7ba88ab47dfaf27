#pragma once

#include <cmath>
#include <compare>
#include <optional>
#include <string_view>

#include "approx/fresnel.hpp"
#include "fit/jet.hpp"

/// What a Fresnel form is fitted to: Schlick's formula or the exact one, of a surface or of none in
/// particular.
namespace shadefit {

/// A smooth surface, and by which formula it reflects.
struct Surface {
  enum class Formula { schlick, exact };

  Formula formula = Formula::schlick;
  double ior = 0;         ///< index of refraction, behind over in front; 0: no surface in particular
  double extinction = 0;  ///< 0: a dielectric; above: a conductor

  auto operator<=>(const Surface&) const = default;

  bool is_named() const { return ior != 0; }
  bool is_exact() const { return formula == Formula::exact; }
};

/// The exact formula for an index of refraction and an extinction.
constexpr Surface exact_surface(double ior, double extinction = 0) {
  return {Surface::Formula::exact, ior, extinction};
}

/// Schlick's formula for the same surface.
constexpr Surface schlick_surface(double ior, double extinction = 0) {
  return {Surface::Formula::schlick, ior, extinction};
}

/// The reflectance at normal incidence, where the surface has none the `reference_f0`.
template <class T>
T normal_reflectance(const Surface& surface) {
  if (!surface.is_named()) return constant<T>(reference_f0);
  if (surface.extinction == 0) return reflectance_at_normal(lift<T>(surface.ior));
  return conductor_reflectance_at_normal(lift<T>(surface.ior), lift<T>(surface.extinction));
}

/// The exact reflectance of a named surface at the cosine c.
template <class T>
T exact_reflectance(const Surface& surface, const T& cos_theta) {
  if (surface.extinction == 0) return dielectric_reflectance(cos_theta, lift<T>(surface.ior));
  return conductor_reflectance(cos_theta, lift<T>(surface.ior), lift<T>(surface.extinction));
}

/// How far the reflectance has gone from f0 to 1 at the cosine c: (F - f0)/(1 - f0).
template <class T>
T target_weight(const Surface& surface, const T& cos_theta) {
  if (!surface.is_exact()) return schlick_weight(cos_theta);
  return weight_of_reflectance(exact_reflectance(surface, cos_theta), normal_reflectance<T>(surface));
}

/// From inside a dielectric (index below 1) everything beyond the critical angle, sin = n, is reflected: the
/// cosine there, where the exact reflectance has a kink.
inline std::optional<double> critical_cosine(const Surface& surface) {
  const bool is_inside = surface.is_exact() && surface.extinction == 0 && surface.ior < 1;
  return is_inside ? std::optional(std::sqrt((1 - surface.ior) * (1 + surface.ior))) : std::nullopt;
}

}  // namespace shadefit
