#pragma once

#include <boost/math/tools/toms748_solve.hpp>
#include <cstdint>

/// Places where a function or a condition changes.
namespace shadefit {

/// A root of f to that many bits, between two places where the values of f, which are given, differ in sign.
/// About ten steps are usual, sixty the limit.
template <class F>
double root_between(const F& f, double low, double high, double at_low, double at_high, unsigned bits) {
  std::uintmax_t steps = 60;
  const auto [below, above] = boost::math::tools::toms748_solve(
      f, low, high, at_low, at_high, boost::math::tools::eps_tolerance<double>(bits), steps);
  return (below + above) / 2;
}

/// The same where the values are not known yet.
template <class F>
double root_between(const F& f, double low, double high, unsigned bits) {
  return root_between(f, low, high, f(low), f(high), bits);
}

/// The last place up to which a condition holds that holds at `low`, not at `high`, and changes once between:
/// by so many halvings.
template <class Holds>
double last_by_halving(double low, double high, int halvings, const Holds& holds) {
  for (int i = 0; i < halvings; ++i) {
    const double middle = (low + high) / 2;
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace shadefit
