#pragma once

#include "approx/scalar.hpp"

/// Schlick's Fresnel term and its approximations by one exp2. c = cos of the angle between view (or light)
/// and half vector, in [0, 1]; reflectances are linear, in [0, 1].
namespace shadefit {

/// (1 - c)^n, n a whole number: Schlick's weight for n = 5. Some shaders use n = 4 instead.
template <class T>
T grazing_power(const T& cos_theta, int n) {
  return power(integer<T>(1) - cos_theta, n);
}

/// (1 - c)^5: the weight that blends the reflectance from f0 (c = 1) to 1 (c = 0).
/// Source: Schlick 1994, "An Inexpensive BRDF Model for Physically-based Rendering".
template <class T>
T schlick_weight(const T& cos_theta) {
  return grazing_power(cos_theta, 5);
}

/// F = f0 + (1 - f0) weight; f0 the reflectance at normal incidence, weight by `schlick_weight` or a form of
/// it.
template <class T>
T schlick_reflectance(const T& f0, const T& weight) {
  return f0 + (integer<T>(1) - f0) * weight;
}

/// F = f0 + (max(g, f0) - f0) weight: for prefiltered light. At grazing angles the reflectance rises only to
/// the gloss g in [0, 1]. f0 is a channel of the specular colour, weight is `schlick_weight` of n.v. With
/// weight in [0, 1] it is the weighted mean f0 (1 - weight) + max(g, f0) weight.
/// Source: Lagarde 2011, "Adopting a physically based shading model".
template <class T>
T schlick_reflectance_of_gloss(const T& f0, const T& gloss, const T& weight) {
  return f0 + (max(gloss, f0) - f0) * weight;
}

/// The reflectance at normal incidence of a dielectric with relative index of refraction n: ((n - 1)/(n +
/// 1))^2.
template <class T>
T reflectance_at_normal(const T& ior) {
  return power((ior - integer<T>(1)) / (ior + integer<T>(1)), 2);
}

/// The exact reflectance of a smooth dielectric in unpolarised light, (rs^2 + rp^2)/2, by Fresnel's
/// equations:
///   rs = (c - n t)/(c + n t), rp = (n c - t)/(n c + t), t = sqrt(1 - (1 - c^2)/n^2) the cosine of the
///   refracted ray.
/// n > 0 is the index behind the surface over the index in front of it: above 1 from outside, below 1 from
/// inside. From inside, everything is reflected beyond the critical angle. Source: Born, Wolf 1999,
/// "Principles of Optics", 7th edition, section 1.5.2.
template <class T>
T dielectric_reflectance(const T& cos_theta, const T& ior) {
  const T one = integer<T>(1), none = integer<T>(0);
  const T squared = one - (one - cos_theta) * (one + cos_theta) / (ior * ior);  // t^2
  const auto partial = [&] {
    const T refracted = sqrt(positive_part(squared));
    const T rs = (cos_theta - ior * refracted) / (cos_theta + ior * refracted);
    const T rp = (ior * cos_theta - refracted) / (ior * cos_theta + refracted);
    return T((rs * rs + rp * rp) / integer<T>(2));
  };
  return choose(less(none, squared), partial, [&] { return one; });
}

/// The weight of a reflectance F between f0 and 1, comparable to `schlick_weight`: (F - f0)/(1 - f0).
template <class T>
T weight_of_reflectance(const T& reflectance, const T& f0) {
  return (reflectance - f0) / (integer<T>(1) - f0);
}

/// The reflectance at normal incidence of a conductor with complex index of refraction n + i k:
/// ((n - 1)^2 + k^2)/((n + 1)^2 + k^2).
template <class T>
T conductor_reflectance_at_normal(const T& ior, const T& extinction) {
  const T k2 = extinction * extinction;
  return (power(ior - integer<T>(1), 2) + k2) / (power(ior + integer<T>(1), 2) + k2);
}

/// The exact reflectance of a smooth conductor in unpolarised light, (|rs|^2 + |rp|^2)/2, by Fresnel's
/// equations.
///
/// Let s^2 = 1 - c^2. For the refracted ray, index times cosine is the complex number sqrt((n + i k)^2 - s^2)
/// = u + i v. Then u^2 + v^2 = m = |(n + i k)^2 - s^2| and u^2 - v^2 = n^2 - k^2 - s^2, so u = sqrt((m + n^2
/// - k^2 - s^2)/2):
///   |rs|^2 = (m - 2 c u + c^2)/(m + 2 c u + c^2)
///   |rp|^2 = |rs|^2 (c^2 m - 2 c u s^2 + s^4)/(c^2 m + 2 c u s^2 + s^4).
/// n > 0, k >= 0. k = 0 is a dielectric, from either side; near the critical angle `dielectric_reflectance`
/// keeps more digits. Source: Born, Wolf 1999, "Principles of Optics", 7th edition, section 14.2.
template <class T>
T conductor_reflectance(const T& cos_theta, const T& ior, const T& extinction) {
  const T two = integer<T>(2);
  const T c2 = cos_theta * cos_theta;
  const T s2 = (integer<T>(1) - cos_theta) * (integer<T>(1) + cos_theta);
  const T real = (ior - extinction) * (ior + extinction) - s2;
  const T imaginary = two * ior * extinction;
  const T m = sqrt(real * real + imaginary * imaginary);
  // computes the larger of u and v without cancellation, then the other from u v = n k
  const T u = choose(
      less(real, integer<T>(0)), [&] { return ior * extinction / sqrt((m - real) / two); },
      [&] { return sqrt((m + real) / two); });
  const T cross = two * cos_theta * u;
  const T rs2 = (m - cross + c2) / (m + cross + c2);
  const T rp_over_rs2 = (c2 * m - cross * s2 + s2 * s2) / (c2 * m + cross * s2 + s2 * s2);
  return rs2 * (integer<T>(1) + rp_over_rs2) / two;
}

/// exp2(-A c), A > 0: one multiplication and one exp2.
template <class T>
T fresnel_one_term(const T& cos_theta, const T& sharpness) {
  return exp2(-(sharpness * cos_theta));
}

/// exp2((a c + b) c): one multiply-add, one multiplication and one exp2.
template <class T>
T fresnel_quadratic(const T& cos_theta, const T& a, const T& b) {
  return exp2((a * cos_theta + b) * cos_theta);
}

/// exp2(((a c + b) c + d) c): one multiply-add more than `fresnel_quadratic`.
template <class T>
T fresnel_cubic(const T& cos_theta, const T& a, const T& b, const T& d) {
  return exp2(((a * cos_theta + b) * cos_theta + d) * cos_theta);
}

/// exp2((((a c + b) c + d) c + g) c): two multiply-adds more than `fresnel_quadratic`.
template <class T>
T fresnel_quartic(const T& cos_theta, const T& a, const T& b, const T& d, const T& g) {
  return exp2((((a * cos_theta + b) * cos_theta + d) * cos_theta + g) * cos_theta);
}

/// s (1 - c)^4: two squarings, scaled. Some shaders use s = 1 instead of Schlick's weight.
template <class T>
T fresnel_fourth(const T& cos_theta, const T& scale) {
  return scale * grazing_power(cos_theta, 4);
}

/// (1 - c)^2 (1 + (a c + b) c): only multiplications and additions. Like the target, it is 1 at c = 0 and 0
/// at c = 1.
template <class T>
T fresnel_square(const T& cos_theta, const T& a, const T& b) {
  return grazing_power(cos_theta, 2) * (integer<T>(1) + (a * cos_theta + b) * cos_theta);
}

/// (1 - c)^4/(1 + a c): a division instead of the exp2. Like the target, it is 1 at c = 0 and 0 at c = 1. It
/// has no pole on [0, 1] for a > -1, and none on [A, B] for a > -1/B.
template <class T>
T fresnel_rational(const T& cos_theta, const T& a) {
  return grazing_power(cos_theta, 4) / (integer<T>(1) + a * cos_theta);
}

/// Relative errors of Fresnel forms are stated for this reflectance at normal incidence: 4 %, as for glass
/// and most plastics (index of refraction 1.5).
inline constexpr std::string_view reference_f0 = "0.04";

}  // namespace shadefit
