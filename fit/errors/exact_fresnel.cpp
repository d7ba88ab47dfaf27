#include "fit/errors/exact_fresnel.hpp"

namespace shadefit {

ReflectanceError schlick_against_exact(double ior, double extinction) {
  return compare_reflectance(exact_surface(ior, extinction),
                             [](const auto& c) { return schlick_weight(c.cos_theta); });
}

}  // namespace shadefit
