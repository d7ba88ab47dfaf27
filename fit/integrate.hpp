#pragma once

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <cstddef>
#include <limits>

/// Two independent quadrature rules, each with an error estimate in the units of its value.
namespace shadefit {

struct Integral {
  double value = 0;
  double error = 0;  ///< an estimate of |value - truth|, rounding included; an estimate is not a bound
};

namespace detail {
/// The sum of n positive terms, each with a few roundings: a handful of epsilons of the total.
inline double rounding_of(double l1) {
  return 8 * std::numeric_limits<double>::epsilon() * l1;
}
}  // namespace detail

/// Adaptive Gauss-Kronrod (15, 31) by Boost.Math, halving where |K - G| exceeds `tolerance` times the
/// integral of |f| (shared out among the halves), at most fifteen times. An error of `negligible`, in the
/// units of the integral, is always good enough: for a part whose whole is known to be larger.
///
/// Boost (1.74 and later) returns the error of a panel as measured on [-1, 1], not scaled to [a, b] as its
/// value and L1 are, and adds such errors up when it halves. So every panel is asked for alone, and its error
/// scaled by (b - a)/2.
template <class F>
Integral gauss_kronrod(const F& f, double a, double b, double tolerance, double negligible = 0) {
  using Rule = boost::math::quadrature::gauss_kronrod<double, 31>;
  const auto panel = [&](double from, double to, double& l1) {
    double error = 0;
    const double value = Rule::integrate(f, from, to, 0, 0.0, &error, &l1);
    return Integral{value, error * (to - from) / 2};
  };
  const auto halve = [&](const auto& self, double from, double to, double allowed, int depth) -> Integral {
    double l1 = 0;
    const Integral whole = panel(from, to, l1);
    if (depth == 0 || whole.error <= std::max(allowed, detail::rounding_of(l1))) {
      return {whole.value, whole.error + detail::rounding_of(l1)};
    }
    const double middle = from + (to - from) / 2;
    const Integral left = self(self, from, middle, allowed / 2, depth - 1);
    const Integral right = self(self, middle, to, allowed / 2, depth - 1);
    return {left.value + right.value, left.error + right.error};
  };
  double l1 = 0;
  panel(a, b, l1);
  return halve(halve, a, b, std::max(tolerance * l1, negligible), 15);
}

/// tanh-sinh by Boost.Math: indifferent to infinite slopes at the ends. f itself has to be finite there: it
/// is given x, not the distance to b, which x has lost close to b.
template <class F>
Integral tanh_sinh(const F& f, double a, double b, double tolerance) {
  double error = 0, l1 = 0;
  std::size_t levels = 0;
  boost::math::quadrature::tanh_sinh<double> rule;
  const double value = rule.integrate(f, a, b, tolerance, &error, &l1, &levels);
  return {value, error + detail::rounding_of(l1)};
}

}  // namespace shadefit
