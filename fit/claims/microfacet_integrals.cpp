#include "fit/claims/microfacet_integrals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

namespace shadefit {
namespace {

/// Distributions are cut off where exp(-distribution_decay) = 1.4e-21 of their area is left.
constexpr double distribution_decay = 48;

/// The square of the slope beyond which a distribution has about exp(-distribution_decay) of its area, the
/// area itself, not its projection along n: Blinn-Phong's is cos to the power s + 1, cos^2 to the power
/// 1/alpha^2 - 1/2; Beckmann's is exp(-tan^2/alpha^2), and at most 1/cos = 7 times that for alpha
/// <= 1. The other distributions fall like powers and are not cut off.
double blinn_phong_reach(double alpha) {
  const double alpha2 = alpha * alpha;
  return std::expm1(distribution_decay * alpha2 / (1 - alpha2 / 2));
}
double beckmann_reach(double alpha) {
  return distribution_decay * (alpha * alpha);
}
double no_reach(double) {
  return std::numeric_limits<double>::infinity();
}

constexpr std::array distributions{
    Distribution{"blinn-phong", blinn_phong_distribution<double>, nullptr, blinn_phong_reach},
    Distribution{"beckmann", beckmann_distribution<double>, beckmann_lambda<double>, beckmann_reach},
    Distribution{"ggx", ggx_distribution<double>, ggx_lambda<double>, no_reach},
    Distribution{"gtr1", gtr1_distribution<double>, nullptr, no_reach}};

double density_at(const Distribution& distribution, const Direction<double>& m, double alpha) {
  return distribution.density({m.cosine * m.cosine, m.sine * m.sine}, alpha);
}

/// Over x = log tan(theta), where theta is the angle between m and n: sin dtheta = sin^2 cos dx. Cut off
/// where exp(-40) of the whole is left at both ends: D is flat to the left, and (n.m) or the size of the
/// circle falls like exp(-x) to the right. `azimuth` is the integral over the azimuth. To the right of `bend`
/// it behaves like the cube of a square root; x = bend + z^2 is smooth there.
template <class Azimuth>
Integral over_slope(const Distribution& distribution, double alpha, const Azimuth& azimuth, double bend,
                    double tolerance) {
  constexpr double margin = 40;
  const auto at = [&](double x) {
    const double slope = std::exp(x);
    const double cosine = 1 / std::sqrt(1 + slope * slope);
    const Direction<double> m{cosine, slope * cosine};
    return density_at(distribution, m, alpha) * azimuth(m) * m.sine * m.sine * m.cosine;
  };
  const double first = std::log(alpha) - margin / 2;
  const double last = std::min(margin, std::log(distribution.reach(alpha)) / 2);
  const double joint = std::clamp(bend, first, last);
  const Integral before = gauss_kronrod(at, first, joint, tolerance);
  if (joint >= last) return before;
  const auto beyond = [&](double z) { return 2 * z * at(joint + z * z); };
  return before + gauss_kronrod(beyond, 0, std::sqrt(last - joint), tolerance, tolerance * before.value);
}

/// Over the sine up to 45 degrees, over the cosine beyond, in panels that meet at `bend`, an angle to n.
/// At the horizon 2^-60 of the hemisphere is left out.
template <class Azimuth>
Integral over_cosine(const Distribution& distribution, double alpha, const Azimuth& azimuth, double bend,
                     double tolerance) {
  const auto by_sine = [&](double sine) {
    const Direction<double> m{std::sqrt((1 - sine) * (1 + sine)), sine};
    return density_at(distribution, m, alpha) * azimuth(m) * m.sine / m.cosine;
  };
  const auto by_cosine = [&](double cosine) {
    const Direction<double> m{cosine, std::sqrt((1 - cosine) * (1 + cosine))};
    return density_at(distribution, m, alpha) * azimuth(m);
  };
  const double end = std::min(std::atan(std::sqrt(distribution.reach(alpha))), std::numbers::pi / 2);
  std::array places{0.0, std::min(bend, end), std::min(std::numbers::pi / 4, end), end};
  std::ranges::sort(places);
  Integral total;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const double from = places[i], to = places[i + 1];
    if (to - from < 1e-15) continue;
    total = total + (to <= std::numbers::pi / 4
                         ? tanh_sinh(by_sine, std::sin(from), std::sin(to), tolerance)
                         : tanh_sinh(by_cosine, std::max(std::cos(to), 0x1p-60), std::cos(from), tolerance));
  }
  return total;
}

/// The azimuth integral of max(v.m, 0). The circle of m meets the plane perpendicular to v where cos(phi) =
/// -cot(theta_v) cot(theta).
auto facing(const View& view) {
  return [view](const Direction<double>& m) {
    const double p = view.direction.cosine * m.cosine, q = view.direction.sine * m.sine;
    if (p >= q) return facing_circle(view.direction, m, Arc<double>{std::numbers::pi, 0, -1});
    const double sine = std::sqrt((q - p) * (q + p)) / q, cosine = -(p / q);
    return facing_circle(view.direction, m, Arc<double>{std::atan2(sine, cosine), sine, cosine});
  };
}

double circumference(const Direction<double>& m) {
  return 2 * std::numbers::pi * m.cosine;
}

}  // namespace

const Distribution& distribution_of(std::string_view name) {
  const auto found = std::ranges::find(distributions, name, &Distribution::name);
  if (found == distributions.end())
    throw std::invalid_argument("distribution '" + std::string(name) + "' is unknown");
  return *found;
}

const Distribution& masking_of(std::string_view name) {
  const Distribution& found = distribution_of(name);
  if (found.lambda == nullptr) throw std::invalid_argument("masking '" + std::string(name) + "' is unknown");
  return found;
}

double masking(const Distribution& by, const View& view, double alpha) {
  return smith_masking(by.lambda(alpha * view.direction.sine / view.direction.cosine));
}

double TwoWays::error() const {
  return std::abs(by_slope.value - by_cosine.value) + std::max(by_slope.error, by_cosine.error);
}

TwoWays integrate_projected_area(const Distribution& distribution, double alpha, double tolerance) {
  return {over_slope(distribution, alpha, circumference, 0, tolerance),
          over_cosine(distribution, alpha, circumference, std::numbers::pi / 4, tolerance)};
}

Integral integrate_visible_area_by_slope(const Distribution& distribution, double alpha, const View& view,
                                         double tolerance) {
  const double bend = std::log(view.direction.cosine / view.direction.sine);  // tan(pi/2 - theta_v)
  return over_slope(distribution, alpha, facing(view), bend, tolerance);
}

TwoWays integrate_visible_area(const Distribution& distribution, double alpha, const View& view,
                               double tolerance) {
  return {integrate_visible_area_by_slope(distribution, alpha, view, tolerance),
          over_cosine(distribution, alpha, facing(view), view.elevation, tolerance)};
}

}  // namespace shadefit
