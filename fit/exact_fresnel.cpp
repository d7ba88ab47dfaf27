#include "fit/exact_fresnel.hpp"

#include "approx/fresnel.hpp"

namespace shadefit {

ReflectanceError schlick_against_exact(double ior) {
  const auto error = [&]<class T>(const Cosine<T>& c) {
    const T f0 = reflectance_at_normal(lift<T>(ior));
    return schlick_reflectance(f0, schlick_weight(c.cos_theta)) -
           dielectric_reflectance(c.cos_theta, lift<T>(ior));
  };
  const auto relative = [&]<class T>(const Cosine<T>& c) {
    return error(c) / dielectric_reflectance(c.cos_theta, lift<T>(ior));
  };
  const Substitution whole(Metric{}, Shape{});
  return {largest_magnitude(error, whole), largest_magnitude(relative, whole)};
}

}  // namespace shadefit
