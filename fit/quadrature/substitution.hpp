#pragma once

#include <algorithm>
#include <cmath>

#include "approx/cosine.hpp"
#include "approx/scalar.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/scalars/jet.hpp"

/// The change of variable that makes an integrand over c smooth, so that Gauss-Legendre converges.
namespace shadefit {

/// The behaviour of a family over c, as the substitution needs it.
struct Shape {
  /// The integrand falls at least as fast as exp(-concentration (1 - c)) from the peak; 0: it is not
  /// concentrated.
  double concentration = 0;
  /// It behaves as c^end_power at c = 0. It is smooth there if this is a whole number.
  double end_power = 0;
};

/// A map of s in [0, 1] onto the domain: s = 0 at its upper end (the peak), s = 1 at its lower end.
///
/// The variable is y = 1 - c for the cosine measures and theta for the angle.
/// - A concentrated integrand is cut where it has fallen below exp(-decay).
/// - A power c^k with k not whole is singular at c = 0. There c (or the angle from the horizon) becomes the
/// q-th
///   power of 1 - s with q (k + 1) >= 8, after which Gauss-Legendre of n nodes converges like n^-16.
class Substitution {
 public:
  Substitution(const Metric& metric, const Shape& shape);

  /// exp(-48) = 1.4e-21; with the factor t^3 of a gradient, t = k(1-c), the cut moves a fit by 2e-17 of
  /// itself.
  static constexpr double decay = 48;

  template <class T>
  struct Place {
    Cosine<T> cosine;
    T density;  ///< of the measure, per ds
  };

  /// The cosine at s; T may carry derivatives with respect to s.
  template <class T>
  Place<T> at(const T& s) const {
    const T one = integer<T>(1);
    const T u = one - s;
    // 1 - u^q = (1 - u) (1 + u + .. + u^(q-1)): the distance from the other end without cancellation
    T sum = one, last = one;  // last = u^(q-1)
    for (int i = 1; i < power_; ++i) {
      sum = sum * u + one;
      last = last * u;
    }
    const T length = lift<T>(length_);
    const T from_peak = length * (s * sum);
    const T from_end = length * (u * last);
    const T density = length * integer<T>(power_) * last;
    const T y = lift<T>(near_) + from_peak;
    const T rest = lift<T>(rest_) + from_end;
    if (measure_ == Measure::cosine) return {{rest, y}, density};
    if (measure_ == Measure::cosine_weighted) return {{rest, y}, rest * density};
    // Near the horizon the cosine is the sine of the distance to it; near the peak it is 1 minus its
    // distance.
    const T half_sine = sin(y / integer<T>(2));
    const T one_minus_cos = integer<T>(2) * half_sine * half_sine;
    const T cos_theta = choose(
        less(y, rest), [&] { return one - one_minus_cos; }, [&] { return sin(rest); });
    return {{cos_theta, one_minus_cos}, density};
  }

 private:
  /// Of a singularity (1 - c)^p or c^p with p > -1.
  static int smoothing_power(double p) { return std::max(1, static_cast<int>(std::ceil(8 / (1 + p)))); }

  Measure measure_;
  int power_ = 1;           ///< q
  long double near_ = 0;    ///< the variable at s = 0
  long double length_ = 1;  ///< and from there to where u is 0
  long double rest_ = 0;    ///< from there to c = 0
};

inline Substitution::Substitution(const Metric& metric, const Shape& shape) : measure_(metric.measure) {
  const long double top = 1.0L - static_cast<long double>(metric.domain.upper);
  const long double bottom = 1.0L - static_cast<long double>(metric.domain.lower);
  const long double cut =
      shape.concentration > 0 ? top + static_cast<long double>(decay / shape.concentration) : bottom;
  const bool is_cut = cut < bottom;
  // theta = 2 asin(sqrt(y/2)), without cancellation near the peak
  const auto variable = [&](long double y) {
    return measure_ == Measure::angle ? 2 * std::asin(std::sqrt(y / 2)) : y;
  };
  near_ = variable(top);
  length_ = variable(is_cut ? cut : bottom) - near_;
  rest_ = metric.domain.lower == 0 && !is_cut ? 0.0L : variable(1.0L) - near_ - length_;
  const bool is_singular = shape.end_power != std::floor(shape.end_power);
  if (is_singular && !is_cut && metric.domain.lower == 0) {
    power_ = smoothing_power(shape.end_power);
  }
}

}  // namespace shadefit
