#include "scene/plan/lobe_error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "approx/shading.hpp"
#include "fit/scalars/rounded_interval.hpp"

namespace shadefit::scene {
namespace {

/// The ratio of a cell's ends. On a cell a lobe falls by a factor of about e^-(0.02 t), t = n y. The
/// important range is t = 1 to 3.
constexpr double cell_ratio = 1.02;
/// The start of the fine cells. Below t = n y = 0.01, and below a cosine of 1e-4, where there is little
/// light, one cell is enough.
constexpr double least_t = 0.01, least_cosine = 1e-4;
/// Safety factor, larger than the rounding of a bound in doubles: 1.1e-16 for each operation and a few times
/// that for functions, with exponents up to 40 and cancellation in a sum of slopes.
constexpr double rounding_up = 1 + 1e-12;
constexpr double derivative_rounding = 1e-13;

/// Doubles are enough: their rounding is negligible compared with the width of a cell.
using Outward = RoundedInterval<OutwardArithmetic>;

/// For a form by slopes: the natural log f/n at y = 1 - c.
Outward form_log(const std::vector<Outward>& slopes, const Outward& y) {
  static constexpr double ln2 = std::numbers::ln2;  // rounded by half an ulp, at most 2^-53
  return Outward(ln2 - 0x1p-53, ln2 + 0x1p-53) * log2_by_slopes(Outward(-y), slopes);
}

/// The ends of d/dc (log f/n) over a cell, in doubles: ln 2 (s1 + 2 s2 z + 3 s3 z^2 ..), z = -y.
Range slope_range(std::span<const double> slopes, double y_low, double y_high) {
  double low = 0, high = 0, size = 0;
  double at_low = std::numbers::ln2, at_high = at_low;  // ln 2 |z|^i
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    const double sign = i % 2 == 0 ? 1 : -1;
    const double s = static_cast<double>(i + 1) * sign * slopes[i];
    low += std::min(s * at_low, s * at_high);
    high += std::max(s * at_low, s * at_high);
    size += std::abs(s * at_high);
    at_low *= y_low;
    at_high *= y_high;
  }
  return {low - derivative_rounding * size, high + derivative_rounding * size};
}

double largest_magnitude(const Range& range) {
  return std::max(std::abs(range.least), std::abs(range.most));
}

/// A cell of cosines [c_low, c_high], given with y = 1 - c of both: one of each pair is rounded, by less than
/// `rounding_up` covers.
LobeCell make_cell(std::span<const double> slopes, const std::vector<Outward>& wide, double c_low,
                   double c_high, double y_low, double y_high) {
  const bool is_near_peak = y_high <= 0.5;
  const double middle = is_near_peak ? y_low + (y_high - y_low) / 2 : c_low + (c_high - c_low) / 2;
  const double half_width = (is_near_peak ? y_high - y_low : c_high - c_low) / 2 * rounding_up;
  const Outward at(middle);
  const Outward form = form_log(wide, is_near_peak ? at : Outward(1) - at);
  const Outward target = is_near_peak ? log1p(Outward(-at)) : log(at);
  const Outward bend = form - target;
  const Range slope = slope_range(slopes, y_low, y_high);
  const Range bend_slope{slope.least - (c_low > 0 ? rounding_up / c_low : HUGE_VAL),
                         slope.most - 1 / (c_high * rounding_up)};
  LobeCell cell;
  cell.weight = std::min(1.0, 2 * c_high * rounding_up);
  cell.y_low = y_low / rounding_up;
  cell.y_high = std::min(1.0, y_high * rounding_up);
  cell.log_target = is_near_peak ? std::log1p(-y_low) / rounding_up : std::log(c_high) / rounding_up;
  cell.log_form = form.upper() + half_width * largest_magnitude(slope);
  const double reach = half_width * largest_magnitude(bend_slope);
  cell.bend_low = bend.lower() - reach;
  cell.bend_high = bend.upper() + reach;
  return cell;
}

}  // namespace

LobeCells::LobeCells(std::span<const double> slopes, double largest_power) {
  std::vector<Outward> wide;
  for (const double slope : slopes) wide.emplace_back(slope);
  const auto add = [&](double c_low, double c_high, double y_low, double y_high) {
    cells_.push_back(make_cell(slopes, wide, c_low, c_high, y_low, y_high));
  };
  double y = std::min(0.5, least_t / largest_power);
  add(1 - y, 1, 0, y);
  while (y < 0.5) {
    const double next = std::min(0.5, y * cell_ratio);
    add(1 - next, 1 - y, y, next);
    y = next;
  }
  double c = 0.5;
  while (c > least_cosine) {
    const double next = c / cell_ratio;
    add(next, c, 1 - c, 1 - next);
    c = next;
  }
  add(0, c, 1 - c, 1);
  double bend = 0, log_from_here = -HUGE_VAL;
  for (LobeCell& cell : cells_)
    cell.bend_so_far = bend = std::max({bend, std::abs(cell.bend_low), std::abs(cell.bend_high)});
  for (auto cell = cells_.rbegin(); cell != cells_.rend(); ++cell)
    cell->log_from_here = log_from_here = std::max({log_from_here, cell->log_target, cell->log_form});
}

double LobeCells::largest_error(const WeightedPower& lobes, double offset, ShownScale scale,
                                double enough) const {
  const double least = lobes.power.least, most = lobes.power.most;
  // power * x, but 0 for a power of 0 and an infinite bend
  const auto times = [](double power, double x) { return power > 0 ? power * x : 0; };
  const auto highest = [&](double x) { return times(x > 0 ? most : least, x); };
  const auto lowest = [&](double x) { return times(x > 0 ? least : most, x); };
  const double most_shown = on_scale(scale, 1);
  // Most cells are ruled out by their logarithms alone, without an exponential. This margin is larger than
  // the rounding.
  constexpr double clearly = 1e-9;
  const double log_factor = std::log(lobes.factor);
  const auto log_of = [&](double shown) { return std::log(from_scale(scale, shown)) - clearly; };
  double largest = enough, log_largest = log_of(largest);
  // Near the peak every form is close to the lobe, and beyond some cell both are small.
  const auto first = std::partition_point(cells_.begin(), cells_.end(), [&](const LobeCell& cell) {
    return (times(most, cell.bend_so_far) + offset * cell.y_high) * most_shown <= largest;
  });
  for (const LobeCell& cell : std::span(first, cells_.end())) {
    if (highest(cell.log_from_here) + log_factor < log_largest) break;
    const double ratio = std::max(std::abs(lowest(cell.bend_low) - offset * cell.y_high),
                                  std::abs(highest(cell.bend_high) - offset * cell.y_low));
    // v S'(v) <= S(1), so a ratio of e^r changes no value by more than |r| S(1)
    if (ratio * most_shown <= largest) continue;
    const double log_larger =
        std::max(highest(cell.log_target), highest(cell.log_form) - offset * cell.y_low);
    if (log_larger + log_factor < log_largest) continue;
    const double shown = lobes.factor * cell.weight * std::exp(log_larger) * rounding_up;
    if (on_scale(scale, shown) <= largest) continue;
    largest = std::max(largest, apart_by_ratio(scale, shown, ratio) * rounding_up);
    log_largest = log_of(largest);
  }
  return largest;
}

}  // namespace shadefit::scene
