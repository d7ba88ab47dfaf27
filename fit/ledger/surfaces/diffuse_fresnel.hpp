#pragma once

#include <string_view>

#include "fit/ledger/finding.hpp"

/// The light that a Lambertian term under a mirror-like Fresnel reflection sends back together with it.
namespace shadefit {

/// What one way of attenuating the Lambertian term does to the sum of both, over all directions of the light
/// and, light and view exchanged, of the view; the larger sum of the two.
struct DiffuseUnderFresnel {
  double at_normal = 0;   ///< the sum at normal incidence
  double at_grazing = 0;  ///< and at grazing incidence: between them it is monotone
  double under_sky = 0;   ///< the mean under a uniform sky, weighted by the cosine
  double error = 0;       ///< how far the two quadrature rules of these are apart, at most
  /// The sum is at most 1 for cosines from here to 1; above 1: at none.
  double from_cosine = 0;
};

/// `factor` is the name of one of the factors of approx/material.hpp, albedo and f0 are in [0, 1]. Throws
/// std::invalid_argument for another name.
DiffuseUnderFresnel diffuse_under_fresnel(std::string_view factor, double albedo, double f0);

/// The claim of two factors, "factor" and "stand-in", at an "albedo" and an "f0"; "beside" is a third.
Finding diffuse_fresnel(const Claim& claim);

}  // namespace shadefit
