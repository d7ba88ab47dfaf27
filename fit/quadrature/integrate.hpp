#pragma once

#include <functional>
#include <limits>

/// Two independent quadrature rules, each with an error estimate in the units of its value.
namespace shadefit {

struct Integral {
  double value = 0;
  double error = 0;  ///< an estimate of |value - truth|, rounding included; an estimate is not a bound
};

/// What the sum of n positive terms, each with a few roundings, is off by: a handful of epsilons of it.
inline double rounding_of(double sum) {
  return 8 * std::numeric_limits<double>::epsilon() * sum;
}

/// Behind a plain function: a rule is compiled once, and not for each function that is integrated.
using Integrand = std::function<double(double)>;

/// Adaptive Gauss-Kronrod (15, 31) by Boost.Math, halving where |K - G| exceeds `tolerance` times the
/// integral of |f| (shared out among the halves), at most fifteen times. An error of `negligible`, in the
/// units of the integral, is always good enough: for a part whose whole is known to be larger.
Integral gauss_kronrod(const Integrand& f, double a, double b, double tolerance, double negligible = 0);

/// tanh-sinh by Boost.Math: indifferent to infinite slopes at the ends. f itself has to be finite there: it
/// is given x, not the distance to b, which x has lost close to b.
Integral tanh_sinh(const Integrand& f, double a, double b, double tolerance);

}  // namespace shadefit
