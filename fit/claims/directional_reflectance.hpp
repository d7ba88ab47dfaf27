#pragma once

#include "approx/reflectance.hpp"
#include "fit/quadrature/integrate.hpp"

/// The integral of a lobe over the hemisphere of lights for a view angle, by two independent methods.
namespace shadefit {

enum class ReflectedLobe { phong, blinn_phong };

/// A view direction: theta_v in degrees, from 0 (along the normal) to less than 90.
///
/// The integrals use its elevation above the horizon: near 90 degrees, theta_v in radians would have lost its
/// digits.
struct View {
  explicit View(double degrees);
  double elevation;  ///< in radians, above 0
  Direction<double> direction;
};

/// By circles around the lobe's axis: the azimuth in closed form, then adaptive Gauss-Kronrod, separately for
/// circles that the horizon intersects and circles above it. Relative `tolerance`.
LobeIntegrand<Integral> reflect_by_circles(ReflectedLobe lobe, double alpha, const View& view,
                                           double tolerance);

/// One of the two integrals of `reflect_by_circles`, for searches.
Integral reflect_by_circles(ReflectedLobe lobe, double alpha, const View& view,
                            double LobeIntegrand<double>::*part, double tolerance);

/// By longitude and latitude, with the pole perpendicular to normal and view: tanh-sinh twice for Phong,
/// whose integral is a product there, and Gauss-Legendre of rising size over the plane for Blinn-Phong.
LobeIntegrand<Integral> reflect_by_longitude(ReflectedLobe lobe, double alpha, const View& view,
                                             double tolerance);

}  // namespace shadefit
