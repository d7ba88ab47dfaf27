#include "fit/claims/directional_reflectance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "approx/normalisation.hpp"
#include "fit/quadrature/gauss.hpp"

namespace shadefit {
namespace {

/// Lobes are cut off at exp(-40) = 4e-18 of their peak. Relative to the reflectance the rest is larger: at
/// the flattest view, the sharpest lobe reflects so little above the horizon that the rest is at most 4e-12
/// of it.
constexpr double lobe_decay = 40;

using Part = double LobeIntegrand<double>::*;

/// The end of a lobe: y = 1 - cos(psi) goes up to `end`; psi is the angle w of Phong and 2 w of Blinn-Phong.
struct Extent {
  double end;
  bool is_cut;  ///< by exp(-lobe_decay); else the hemisphere or the clamp ends there
};

Extent extent_of(ReflectedLobe lobe, double alpha, const View& view) {
  const bool is_phong = lobe == ReflectedLobe::phong;
  const double sharpness = is_phong ? PhongLobe::sharpness : BlinnPhongLobe::sharpness;
  // r.l is clamped at psi = pi/2; half vectors reach psi = pi/2 + theta_v
  const double whole = is_phong ? 1 : 1 + view.direction.sine;
  const double cut = lobe_decay / (sharpness * alpha);
  return {std::min(whole, cut), cut < whole};
}

double circle(ReflectedLobe lobe, double y, double alpha, const View& view, const Arc<double>& arc,
              Part part) {
  return (lobe == ReflectedLobe::phong ? phong_circle(y, alpha, view.direction, arc)
                                       : blinn_phong_circle(y, alpha, view.direction, arc)).*
         part;
}

/// The circles that the horizon intersects.
///
/// With psi the angle from the axis to l (w of Phong, 2 w of Blinn-Phong), cos(phi) = -tan(e) cot(psi) at the
/// horizon, where e is the elevation of the view. The arc shrinks from a circle at psi = e to zero at pi - e,
/// at both ends like a square root, and close to e on the scale of e. In x = log tan(psi/2) both are smooth:
/// cot(psi) = -sinh(x), so cos(phi) = tan(e) sinh(x) for -X <= x <= X, sinh(X) = cot(e), and x = middle
/// - half cos(s) turns the roots into sin(s/2) and cos(s/2).
///
/// An error of `negligible` is accepted: at theta_v = 0 only a sliver of these circles is left, by rounding.
Integral cut_circles(ReflectedLobe lobe, double alpha, const View& view, const Extent& extent, Part part,
                     double tolerance, double negligible) {
  const double tangent = view.direction.cosine / view.direction.sine;  // tan(e)
  const double first = -std::asinh(1 / tangent);
  const double rest = lobe == ReflectedLobe::phong ? 0 : -first;
  const double last = extent.is_cut ? std::log(extent.end / (2 - extent.end)) / 2 : rest;
  const double half = (last - first) / 2;
  const auto density = [&](double s) {
    const double low = std::sin(s / 2), high = std::cos(s / 2);
    const double from_first = 2 * half * low * low;
    const double to_end = 2 * half * high * high - first - last;  // X - x
    const double x = first + from_first;
    const double e2 = std::exp(2 * x);
    const double y = 2 * e2 / (1 + e2);
    const double sine = tangent * std::sqrt(std::sinh(from_first) * std::sinh(to_end));
    const double cosine = tangent * std::sinh(x);
    const Arc<double> arc{std::atan2(sine, cosine), sine, cosine};
    return circle(lobe, y, alpha, view, arc, part) * y * (2 - y) * half * std::sin(s);
  };
  return gauss_kronrod(density, 0, std::numbers::pi, tolerance, negligible);
}

}  // namespace

View::View(double degrees)
    : elevation((90 - degrees) / 180 * std::numbers::pi),
      direction{std::sin(elevation), std::cos(elevation)} {}

Integral reflect_by_circles(ReflectedLobe lobe, double alpha, const View& view, Part part, double tolerance) {
  const Extent extent = extent_of(lobe, alpha, view);
  const double half_sine = std::sin(view.elevation / 2);
  const double whole_circles = 2 * half_sine * half_sine;  // y at psi = e
  const double last_whole = std::min(extent.end, whole_circles);
  const Arc<double> all{std::numbers::pi, 0, -1};
  const Integral inner = gauss_kronrod([&](double y) { return circle(lobe, y, alpha, view, all, part); }, 0,
                                       last_whole, tolerance);
  const bool is_horizon_met = extent.end > whole_circles;
  const Integral outer =
      is_horizon_met ? cut_circles(lobe, alpha, view, extent, part, tolerance, tolerance * inner.value)
                     : Integral{};
  // the rest is at most the lobe at the cut, over the whole hemisphere
  const double tail = extent.is_cut ? 2 * std::numbers::pi * std::exp(-lobe_decay) : 0;
  return inner + outer + Integral{0, tail};
}

LobeIntegrand<Integral> reflect_by_circles(ReflectedLobe lobe, double alpha, const View& view,
                                           double tolerance) {
  return {reflect_by_circles(lobe, alpha, view, &LobeIntegrand<double>::plain, tolerance),
          reflect_by_circles(lobe, alpha, view, &LobeIntegrand<double>::with_cosine, tolerance)};
}

namespace {

/// The argument at which (1-z^2)^(a/2), or the cosine of a longitude to the power a, has fallen to
/// exp(-lobe_decay). Both are at most exp(-a x^2 / 2).
double reach_of(double alpha) {
  return std::sqrt(2 * lobe_decay / alpha);
}

/// Phong is a product of two integrals.
Integral phong_by_longitude(double alpha, const View& view, Part part, double tolerance) {
  const double reach = reach_of(alpha);
  const auto longitude =
      tanh_sinh([&](double g) { return phong_longitude(g, alpha, view.elevation).*part; },
                -std::min(view.elevation, reach), std::min(std::numbers::pi / 2, reach), tolerance);
  const auto latitude =
      tanh_sinh([&](double z) { return phong_latitude(z, alpha).*part; }, 0, std::min(1.0, reach), tolerance);
  return {2 * longitude.value * latitude.value,
          2 * (longitude.error * latitude.value + longitude.value * latitude.error)};
}

/// Twice the integrals over 0 < z < length: both hemispheres of the pole.
LatitudeMoments<double> blinn_phong_latitudes(double length, double alpha,
                                              const std::vector<GaussNode<double>>& nodes) {
  LatitudeMoments<double> sum{};
  for (const GaussNode<double>& node : nodes) {
    const auto value = blinn_phong_latitude(length * node.position, alpha);
    sum.one += node.weight * value.one;
    sum.z_squared += node.weight * value.z_squared;
  }
  return {2 * length * sum.one, 2 * length * sum.z_squared};
}

/// Blinn-Phong by Gauss-Legendre rules over longitude and latitude.
///
/// The latitude of the horizon has square roots at g = 0 and pi/2, and bends near them on the scale of the
/// elevation e. In g = e sinh^2(t) from either end it is smooth. Panels meet at pi/4 and at the peak of the
/// lobe, e/2: each contains at most one side of the peak.
LobeIntegrand<double> blinn_phong_plane(double alpha, const View& view,
                                        const std::vector<GaussNode<double>>& outer_nodes,
                                        const std::vector<GaussNode<double>>& inner_nodes) {
  const double e = view.elevation, reach = reach_of(alpha), peak = e / 2;
  const double last = std::min(std::numbers::pi / 2, peak + reach),
               middle = std::min(std::numbers::pi / 4, last);
  // a lobe that ends below the horizon has the same latitudes at every longitude
  const auto whole_latitudes = blinn_phong_latitudes(std::min(reach, 1.0), alpha, inner_nodes);
  LobeIntegrand<double> total{};
  const auto add_panel = [&](double from, double to, bool is_from_the_end) {
    const double t0 = std::asinh(std::sqrt(from / e)), t1 = std::asinh(std::sqrt(to / e));
    for (const GaussNode<double>& node : outer_nodes) {
      const double t = t0 + (t1 - t0) * node.position;
      const double s = std::sinh(t);
      const double g = is_from_the_end ? std::numbers::pi / 2 - e * s * s : e * s * s;
      const double horizon = horizon_latitude(g, e);
      const auto latitudes =
          horizon < reach ? blinn_phong_latitudes(horizon, alpha, inner_nodes) : whole_latitudes;
      const auto value = blinn_phong_meridian(g, alpha, e, latitudes);
      const double weight = node.weight * (t1 - t0) * 2 * e * s * std::cosh(t);
      total.plain += weight * value.plain;
      total.with_cosine += weight * value.with_cosine;
    }
  };
  add_panel(std::max(0.0, peak - reach), std::min(peak, middle), false);
  if (peak < middle) add_panel(peak, middle, false);
  if (middle < last) add_panel(std::numbers::pi / 2 - last, std::numbers::pi / 2 - middle, true);
  return total;
}

/// Rules of rising size over the longitude, until two agree. The latitudes converge with the first size,
/// because their integrand is a polynomial or half a bell; after that they use the second size.
LobeIntegrand<Integral> blinn_phong_by_longitude(double alpha, const View& view, double tolerance) {
  // Each is 1.5 times as large as the one before: if two neighbours agree, both have converged.
  constexpr std::array sizes{26U, 38U, 56U, 84U, 126U, 190U};
  LobeIntegrand<Integral> result{};
  for (const unsigned size : sizes) {
    const auto value = blinn_phong_plane(alpha, view, gauss_nodes<double>(size),
                                         gauss_nodes<double>(std::min(size, sizes[1])));
    const auto step = [](const Integral& before, double now) {
      return Integral{now, std::abs(now - before.value) + rounding_of(now)};
    };
    result = {step(result.plain, value.plain), step(result.with_cosine, value.with_cosine)};
    const auto is_done = [&](const Integral& i) { return i.error <= tolerance * i.value; };
    if (is_done(result.plain) && is_done(result.with_cosine)) break;
  }
  return result;
}

}  // namespace

LobeIntegrand<Integral> reflect_by_longitude(ReflectedLobe lobe, double alpha, const View& view,
                                             double tolerance) {
  if (lobe == ReflectedLobe::blinn_phong) return blinn_phong_by_longitude(alpha, view, tolerance);
  return {phong_by_longitude(alpha, view, &LobeIntegrand<double>::plain, tolerance),
          phong_by_longitude(alpha, view, &LobeIntegrand<double>::with_cosine, tolerance)};
}

}  // namespace shadefit
