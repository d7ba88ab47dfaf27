#pragma once

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

/// Adaptive Gauss-Kronrod (15, 31) by Boost.Math. Up to 1.74 and later Boost returns the error as measured on
/// [-1, 1], not scaled to [a, b] as value and L1 are: |K - G| on [a, b] is (b - a)/2 of it. `tolerance` is
/// relative to the integral of |f|.
template <class F>
Integral gauss_kronrod(const F& f, double a, double b, double tolerance) {
  double error = 0, l1 = 0;
  const double value =
      boost::math::quadrature::gauss_kronrod<double, 31>::integrate(f, a, b, 15, tolerance, &error, &l1);
  return {value, error * (b - a) / 2 + detail::rounding_of(l1)};
}

/// tanh-sinh by Boost.Math: indifferent to singularities at the ends. f is not evaluated at a and b
/// themselves.
template <class F>
Integral tanh_sinh(const F& f, double a, double b, double tolerance) {
  double error = 0, l1 = 0;
  std::size_t levels = 0;
  boost::math::quadrature::tanh_sinh<double> rule;
  const double value = rule.integrate(f, a, b, tolerance, &error, &l1, &levels);
  return {value, error + detail::rounding_of(l1)};
}

}  // namespace shadefit
