#pragma once

#include <string_view>

/// The total reflected light of a Lambertian term and a mirror-like Fresnel reflection above it.
namespace shadefit {

/// The sum of both for one way of attenuating the Lambertian term, over all directions of the light, and over
/// all directions of the view with light and view exchanged; the larger of the two.
struct DiffuseUnderFresnel {
  double at_normal = 0;   ///< the sum at normal incidence
  double at_grazing = 0;  ///< and at grazing incidence; between them it is monotonic
  double under_sky = 0;   ///< the mean under a uniform sky, weighted by the cosine
  double error = 0;       ///< the largest difference of the two quadrature rules
  /// The sum is at most 1 for cosines from here to 1; above 1 if for none.
  double from_cosine = 0;
};

/// `factor` is the name of one of the factors of approx/material.hpp, albedo and f0 are in [0, 1]. Throws
/// std::invalid_argument for another name.
DiffuseUnderFresnel diffuse_under_fresnel(std::string_view factor, double albedo, double f0);

}  // namespace shadefit
