#pragma once

#include <string_view>

#include "approx/microfacet.hpp"
#include "fit/claims/directional_reflectance.hpp"
#include "fit/quadrature/integrate.hpp"

/// Integrals over the hemisphere of microfacet normals, by two independent methods.
namespace shadefit {

/// A distribution of microfacet normals.
struct Distribution {
  std::string_view name;
  double (*density)(const MicrofacetNormal<double>& m, const double& alpha);
  double (*lambda)(
      const double& slope);       ///< Smith's, of the slope alpha tan(theta_v); null: not in closed form
  double (*reach)(double alpha);  ///< the square of the slope beyond which nothing counts
};

/// "blinn-phong", "beckmann", "ggx", "gtr1". Throws std::invalid_argument, naming the text, for anything
/// else.
const Distribution& distribution_of(std::string_view name);

/// The distribution whose Lambda gives the masking: "beckmann", "ggx". Throws the same.
const Distribution& masking_of(std::string_view name);

/// Smith's G1 for a view direction.
double masking(const Distribution& by, const View& view, double alpha);

/// One integral by two methods: Gauss-Kronrod over the logarithm of the slope, in which every distribution is
/// wide; and tanh-sinh over the sine near the normal and the cosine near the horizon.
struct TwoWays {
  Integral by_slope;
  Integral by_cosine;
  double value() const { return by_slope.value; }
  /// The larger estimate plus the difference of the values.
  double error() const;
};

/// The integral of D(m) (n.m), which should be 1. 0 < alpha <= 1.
TwoWays integrate_projected_area(const Distribution& distribution, double alpha, double tolerance);

/// The integral of D(m) max(v.m, 0), which should be (v.n)/G1(v). 0 < alpha <= 1.
TwoWays integrate_visible_area(const Distribution& distribution, double alpha, const View& view,
                               double tolerance);

/// By the first method only, for searches.
Integral integrate_visible_area_by_slope(const Distribution& distribution, double alpha, const View& view,
                                         double tolerance);

}  // namespace shadefit
