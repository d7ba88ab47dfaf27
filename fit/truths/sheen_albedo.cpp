#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "fit/truths/albedo_rules.hpp"
#include "fit/truths/graded_rule.hpp"

namespace shadefit {
namespace {

constexpr double pi_of_sheen = std::numbers::pi;

/// The integral of sin(h)^(1/alpha) over the azimuth, for a light at this elevation.
double sheen_ring(double elevation, double half_difference, double sines, double alpha) {
  const double cosine_m = std::sin(elevation - half_difference), sine_d = std::sin(half_difference);
  const double square_m = cosine_m * cosine_m, square_d = sine_d * sine_d, power = 1 / (2 * alpha);
  if (!(sines > 0)) return 2 * pi_of_sheen * std::pow(square_d, power);
  // A narrow lobe is nothing where sin^2 h is small.
  const double near = alpha >= 0.25 ? square_d : 1 + square_d;
  const double scale = std::max(std::sqrt(square_m * near / sines), 1e-100);
  const std::size_t azimuths = alpha < 0.05 || alpha >= 0.25 ? 48 : 24;
  double sum = 0;
  visit_graded(
      scale, pi_of_sheen / 2, [&](double) { return azimuths; },
      [&](double half, double weight) {
        const double sine = std::sin(half), turn = sines * sine * sine;
        sum += weight * std::pow((square_m * square_d + turn) / (square_m + turn), power);
      });
  return 4 * sum;
}

}  // namespace

double sheen_albedo(double c, double alpha, double most) {
  const double sine = std::sqrt((1 - c) * (1 + c)), top = std::atan2(c, sine), zenith = pi_of_sheen / 2;
  // The visibility is cut off where l + c - l c is less than this.
  const double reach = 1 / (4 * most);
  std::vector<double> cuts{0, top, zenith};
  if (c < reach) cuts.push_back(std::asin((reach - c) / (1 - c)));
  std::ranges::sort(cuts);
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  // The narrowest lobes need more nodes.
  const double nodes_per_k = alpha < 0.004 ? 8 : 5;
  double sum = 0;
  const auto add = [&](double elevation, double half_difference, double weight) {
    const double cosine = std::cos(elevation), l = std::sin(elevation);
    sum += weight * cosine * l * std::min(most, 1 / (4 * (l + c - l * c))) *
           sheen_ring(elevation, half_difference, cosine * sine, alpha);
  };
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    // In the mirrored view the lobe has a root of sin(h). With t^3 the nodes are close to it, and to the
    // horizon.
    const bool is_above = cuts[i + 1] != top;
    const double start = is_above ? cuts[i] : top, length = cuts[i + 1] - cuts[i];
    const double scale = start == top ? std::max(top, 1e-12) : length, k = std::asinh(length / scale);
    for (const auto& [t, weight] : gauss_on_unit(static_cast<std::size_t>(48 + nodes_per_k * k))) {
      const double rising = std::exp(k * t * t * t), falling = 1 / rising;
      const double from_start = (is_above ? 1 : -1) * scale * (rising - falling) / 2;
      add(start + from_start, (start == top ? from_start : start + from_start - top) / 2,
          weight * 3 * t * t * k * scale * (rising + falling) / 2);
    }
  }
  return (2 + 1 / alpha) / (2 * pi_of_sheen) * sum;
}

}  // namespace shadefit
