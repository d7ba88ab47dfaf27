#pragma once

#include <algorithm>
#include <cmath>

#include "approx/encoding.hpp"
#include "fit/errors/extremum.hpp"
#include "fit/families/surface.hpp"

/// The error of a curve against the reflectance of a surface: an approximation against Schlick's formula, or
/// either against the exact formula.
namespace shadefit {

struct ReflectanceError {
  Extremum absolute;  ///< of F, in [0, 1]
  Extremum relative;  ///< of F over the reflectance of the surface
  double srgb_codes;  ///< the largest, in 8-bit sRGB codes (a real number: 1 is one code)
};

/// A form, which maps a Cosine<T> to its weight, against the target of a surface, over all of c.
template <class Form>
ReflectanceError compare_reflectance(const Surface& surface, const Form& form) {
  const auto f0 = normal_reflectance<double>(surface);
  const auto reflectance = [&]<class T>(const T& weight) { return schlick_reflectance(lift<T>(f0), weight); };
  const auto target = [&]<class T>(const Cosine<T>& c) {
    return surface.is_exact() ? exact_reflectance(surface, c.cos_theta)
                              : reflectance(schlick_weight(c.cos_theta));
  };
  const auto error = [&](const auto& c) { return reflectance(form(c)) - target(c); };
  const auto relative = [&](const auto& c) { return error(c) / target(c); };

  const auto panels = Substitution::panels({}, Shape{.joint = joint_of(surface)}.for_search());
  ReflectanceError result{largest_magnitude(error, panels), largest_magnitude(relative, panels), 0};
  for (const Substitution& panel : panels) {
    const auto codes = [&](double s) {
      const Cosine<double> c = panel.at(s).cosine;
      return std::abs(srgb_code(reflectance(form(c))) - srgb_code(target(c)));
    };
    result.srgb_codes = std::max(result.srgb_codes, largest_sampled(codes));
  }
  return result;
}

/// Schlick's formula, with f0 from the surface, against the exact one of the same surface.
inline ReflectanceError schlick_against_exact(double ior, double extinction = 0) {
  return compare_reflectance(exact_surface(ior, extinction),
                             [](const auto& c) { return schlick_weight(c.cos_theta); });
}

}  // namespace shadefit
