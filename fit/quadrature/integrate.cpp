#include "fit/quadrature/integrate.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cstddef>

namespace shadefit {
namespace {

/// A panel's integral, and that of |f|. Boost (1.74 and later) scales its value and L1 to [a, b], but not its
/// error, which belongs to [-1, 1]; it also adds up such errors when it halves. So every panel is integrated
/// alone, and its error is scaled by (b - a)/2.
Integral panel(const Integrand& f, double from, double to, double& l1) {
  double error = 0;
  const double value = boost::math::quadrature::gauss_kronrod<double, 31>::integrate(
      [&f](double x) { return f(x); }, from, to, 0, 0.0, &error, &l1);
  return {value, error * (to - from) / 2};
}

Integral halved(const Integrand& f, double from, double to, double allowed, int depth) {
  double l1 = 0;
  const Integral whole = panel(f, from, to, l1);
  if (depth == 0 || whole.error <= std::max(allowed, rounding_of(l1)))
    return {whole.value, whole.error + rounding_of(l1)};
  const double middle = from + (to - from) / 2;
  const Integral left = halved(f, from, middle, allowed / 2, depth - 1);
  const Integral right = halved(f, middle, to, allowed / 2, depth - 1);
  return {left.value + right.value, left.error + right.error};
}

}  // namespace

Integral gauss_kronrod(const Integrand& f, double a, double b, double tolerance, double negligible) {
  constexpr int halvings = 15;
  double l1 = 0;
  panel(f, a, b, l1);
  return halved(f, a, b, std::max(tolerance * l1, negligible), halvings);
}

Integral tanh_sinh(const Integrand& f, double a, double b, double tolerance) {
  double error = 0, l1 = 0;
  std::size_t levels = 0;
  boost::math::quadrature::tanh_sinh<double> rule;
  // Boost integrates over [0, 1] only: in a narrow [a, b] its places round onto the ends, and then an
  // assertion of Boost fails.
  const double length = b - a;
  const double mean = rule.integrate([&](double t) { return f(std::min(a + length * t, b)); }, 0.0, 1.0,
                                     tolerance, &error, &l1, &levels);
  return {length * mean, length * (error + rounding_of(l1))};
}

}  // namespace shadefit
