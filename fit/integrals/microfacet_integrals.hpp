#pragma once

#include <string_view>

#include "approx/microfacet.hpp"
#include "fit/integrals/directional_reflectance.hpp"
#include "fit/quadrature/integrate.hpp"

/// Integrals over the hemisphere of microfacet normals, by two independent ways.
namespace shadefit {

enum class Distribution { blinn_phong, beckmann, ggx, gtr1 };

/// Whose Lambda masks.
enum class Masking { beckmann, ggx };

/// "blinn-phong", "beckmann", "ggx", "gtr1". Throws std::invalid_argument, naming the text, for anything
/// else.
Distribution distribution_of(std::string_view name);

/// "beckmann", "ggx". Throws std::invalid_argument, naming the text, for anything else.
Masking masking_of(std::string_view name);

double density(Distribution distribution, const MicrofacetNormal<double>& m, double alpha);

/// Smith's G1 at a view.
double masking(Masking masking, const View& view, double alpha);

/// Two values of one integral: Gauss-Kronrod over the logarithm of the slope, in which every distribution is
/// wide; and tanh-sinh over the sine from the normal on, the cosine from the horizon on.
struct TwoWays {
  Integral by_slope;
  Integral by_cosine;
  double value() const { return by_slope.value; }
  /// The larger of both estimates and their difference together.
  double error() const;
};

/// The integral of D(m) (n.m), which should be 1. 0 < alpha <= 1.
TwoWays integrate_projected_area(Distribution distribution, double alpha, double tolerance);

/// The integral of D(m) max(v.m, 0), which should be (v.n)/G1(v). 0 < alpha <= 1.
TwoWays integrate_visible_area(Distribution distribution, double alpha, const View& view, double tolerance);

/// The first of both ways alone, for searches.
Integral integrate_visible_area_by_slope(Distribution distribution, double alpha, const View& view,
                                         double tolerance);

}  // namespace shadefit
