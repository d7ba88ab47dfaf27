#pragma once

#include "approx/scalar.hpp"

/// Materials: metals and dielectrics. Colours and reflectances are linear, one channel, in [0, 1].
namespace shadefit {

/// The reflectance at normal incidence of the metallic workflow: linear from the common value of all
/// dielectrics (m = 0) to the base colour c (m = 1).
/// Source: Pestana 2014, "Physically Based Shading, Metallic and Specular workflows".
template <class T>
T metallic_f0(const T& dielectric_f0, const T& base_colour, const T& metallic) {
  return dielectric_f0 + metallic * (base_colour - dielectric_f0);
}

}  // namespace shadefit
