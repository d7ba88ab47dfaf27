#pragma once

#include "approx/reflectance.hpp"
#include "fit/quadrature/integrate.hpp"

/// The integral of a lobe over the hemisphere of lights, seen from an angle, by two independent ways.
namespace shadefit {

enum class ReflectedLobe { phong, blinn_phong };

/// A view direction: theta_v in degrees, from 0 (along the normal) to less than 90.
///
/// What the integrals ask for is its elevation above the horizon, which near 90 degrees theta_v in radians
/// would have lost.
struct View {
  explicit View(double degrees);
  double elevation;  ///< in radians, above 0
  Direction<double> direction;
};

/// By circles around the lobe's axis: the azimuth in closed form, then adaptive Gauss-Kronrod, the circles
/// that the horizon cuts apart from those that it does not. Relative `tolerance`.
LobeIntegrand<Integral> reflect_by_circles(ReflectedLobe lobe, double alpha, const View& view,
                                           double tolerance);

/// One of the two integrals of `reflect_by_circles`, for searches.
Integral reflect_by_circles(ReflectedLobe lobe, double alpha, const View& view,
                            double LobeIntegrand<double>::*part, double tolerance);

/// By longitude and latitude around the pole that is square to normal and view: tanh-sinh twice for Phong,
/// whose integral is a product there, and Gauss-Legendre of rising size over the plane for Blinn-Phong.
LobeIntegrand<Integral> reflect_by_longitude(ReflectedLobe lobe, double alpha, const View& view,
                                             double tolerance);

}  // namespace shadefit
