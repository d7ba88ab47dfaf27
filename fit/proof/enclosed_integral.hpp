#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "approx/cosine.hpp"
#include "fit/proof/interval.hpp"
#include "fit/proof/interval_ends.hpp"
#include "fit/proof/taylor.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/support/checkpoint.hpp"

/// Enclosed integrals over the cosine: the enclosure includes every rounding and the remainder of the
/// quadrature.
namespace shadefit {

/// The most panels of an integral.
inline constexpr int most_panels = 4000;

/// A part of the domain. The variable is the distance from one side, 1 - c or c; for the angle measure it is
/// the angle from the peak or from the horizon.
struct IntegralPanel {
  bool is_at_peak;
  Interval lower, upper;
};

/// The domain in panels that meet at c = 1/2, so nothing cancels near the ends of [0, 1].
inline std::vector<IntegralPanel> panels_of(const Metric& metric) {
  const Domain& domain = metric.domain;
  const Interval half = Interval(1) / Interval(2), one(1);
  const bool is_angle = metric.measure == Measure::angle;
  // The angle from the peak is 2 asin(sqrt((1-c)/2)), from the horizon asin(c): both by atan.
  const auto from_peak = [&](const Interval& y) {
    return is_angle ? Interval(Interval(2) * atan(sqrt(y / (Interval(2) - y)))) : y;
  };
  const auto from_horizon = [&](const Interval& c) {
    return is_angle ? atan(c / sqrt((one - c) * (one + c))) : c;
  };
  const Interval lower(domain.lower), upper(domain.upper);
  std::vector<IntegralPanel> panels;
  if (domain.upper > 0.5)
    panels.push_back({true, from_peak(one - upper), from_peak(domain.lower < 0.5 ? half : one - lower)});
  if (domain.lower < 0.5)
    panels.push_back({false, from_horizon(lower), from_horizon(domain.upper > 0.5 ? half : upper)});
  return panels;
}

/// A cosine and the density of the measure there, for a variable of a panel.
template <class T>
struct WeightedCosine {
  Cosine<T> cosine;
  T density;
};

template <class T>
WeightedCosine<T> weighted_cosine(Measure measure, bool is_at_peak, const T& s) {
  const T one = integer<T>(1);
  if (measure == Measure::angle) {
    if (!is_at_peak) return {{sin(s), one - sin(s)}, one};
    const T half_sine = sin(s / integer<T>(2));
    const T one_minus_cos = integer<T>(2) * half_sine * half_sine;
    return {{one - one_minus_cos, one_minus_cos}, one};
  }
  const Cosine<T> c = is_at_peak ? Cosine<T>{one - s, s} : Cosine<T>{s, one - s};
  return {c, measure == Measure::cosine_weighted ? c.cos_theta : one};
}

/// Integrals of N functions at once, over the measure and the domain of a metric. `integrand` maps a
/// Cosine<T> to N values for T = Interval and Taylor<Order>. Panels are cut until each adds at most its part
/// of `tolerance` to the width of every integral; empty if there are too many. The checkpoint is called for
/// each panel.
///
/// On a panel [m-r, m+r] the integral of f is the sum of 2 f_j r^(j+1)/(j+1) over even j < Order, f_j the
/// coefficients at m, and the remainder 2 f_Order r^(Order+1)/(Order+1) with f_Order enclosed on all of the
/// panel, Order even: the mean of the remainder's derivative, by Lagrange. Where f has no series, as c^k at c
/// = 0, the panel's length times the range of f is used.
template <int Order, std::size_t N>
class EnclosedIntegral {
 public:
  using Values = std::array<Interval, N>;
  static_assert(Order % 2 == 0);

  EnclosedIntegral(const Metric& metric, const std::array<double, N>& tolerances)
      : metric_(metric), tolerances_(tolerances) {}

  template <class Integrand>
  std::optional<Values> of(const Integrand& integrand, const Checkpoint& checkpoint = keep_going) {
    Values sum{};
    std::vector<IntegralPanel> open = panels_of(metric_);
    for (int count = 0; !open.empty(); ++count) {
      checkpoint();
      if (count == most_panels) return std::nullopt;
      const IntegralPanel panel = open.back();
      open.pop_back();
      if (const auto part = part_of(integrand, panel)) {
        for (std::size_t i = 0; i < N; ++i) sum[i] = sum[i] + (*part)[i];
        continue;
      }
      const Interval centre = (panel.lower + panel.upper) / Interval(2);
      open.push_back({panel.is_at_peak, panel.lower, centre});
      open.push_back({panel.is_at_peak, centre, panel.upper});
    }
    return sum;
  }

 private:
  using Series = Taylor<Order>;

  /// About fifty panels contribute to an integral.
  static constexpr double parts = 64;

  bool is_fine(const Values& values) const {
    for (std::size_t i = 0; i < N; ++i) {
      if (!is_bounded(values[i])) return false;
      if (!(width_of(values[i]) <= tolerances_[i] / parts)) return false;
    }
    return true;
  }

  template <class T, class Integrand>
  auto at(const Integrand& integrand, const IntegralPanel& panel, const T& s) const {
    const auto place = weighted_cosine(metric_.measure, panel.is_at_peak, s);
    auto values = integrand(place.cosine);
    for (auto& value : values) value = place.density * value;
    return values;
  }

  /// The integrals over a panel, if they are narrow enough.
  template <class Integrand>
  std::optional<Values> part_of(const Integrand& integrand, const IntegralPanel& panel) const {
    const Interval all = Scalar<Interval>::hull(panel.lower, panel.upper);
    const Interval length = panel.upper - panel.lower;
    Values values = at(integrand, panel, all);
    for (Interval& value : values) value = length * value;
    if (is_fine(values)) return values;
    const Interval centre = (panel.lower + panel.upper) / Interval(2), radius = length / Interval(2);
    const auto rest = at(integrand, panel, Series::variable(all));
    for (std::size_t i = 0; i < N; ++i) values[i] = moment(rest[i][Order], radius, Order);
    if (!is_fine(values)) return std::nullopt;
    const auto series = at(integrand, panel, Series::variable(centre));
    for (std::size_t i = 0; i < N; ++i) {
      for (int j = 0; j < Order; j += 2) values[i] = values[i] + moment(series[i][j], radius, j);
    }
    return is_fine(values) ? std::optional(values) : std::nullopt;
  }

  /// The integral of coefficient * s^j over [-radius, radius], j even.
  static Interval moment(const Interval& coefficient, const Interval& radius, int j) {
    return Interval(2) * coefficient * power(radius, j + 1) / Interval(j + 1);
  }

  Metric metric_;
  std::array<double, N> tolerances_;
};

}  // namespace shadefit
