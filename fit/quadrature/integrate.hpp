#pragma once

#include <functional>
#include <limits>

/// Two independent quadrature rules, each with an error estimate in the units of its value.
namespace shadefit {

struct Integral {
  double value = 0;
  double error = 0;  ///< an estimate of |value - truth|, rounding included; an estimate is not a bound
};

/// The sum, with the sum of the errors.
inline Integral operator+(const Integral& a, const Integral& b) {
  return {a.value + b.value, a.error + b.error};
}

/// The error of a sum of positive terms, each with a few roundings: a few epsilons of the sum.
inline double rounding_of(double sum) {
  return 8 * std::numeric_limits<double>::epsilon() * sum;
}

/// A plain function, so that a rule is compiled once and not for each integrand.
using Integrand = std::function<double(double)>;

/// Adaptive Gauss-Kronrod (15, 31) by Boost.Math, with at most fifteen halvings where |K - G| exceeds
/// `tolerance` times the integral of |f| (shared among the halves). An error below `negligible`, in the units
/// of the integral, is always accepted: this is for a part of a larger whole.
Integral gauss_kronrod(const Integrand& f, double a, double b, double tolerance, double negligible = 0);

/// tanh-sinh by Boost.Math: infinite slopes at the ends do no harm. f itself must be finite there: its
/// argument is x, which close to b does not tell the distance to b.
Integral tanh_sinh(const Integrand& f, double a, double b, double tolerance);

}  // namespace shadefit
