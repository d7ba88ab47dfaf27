#pragma once

#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/erf.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <string>

#include "approx/scalar.hpp"
#include "fit/scalars/albedo_in.hpp"

/// The adapter of Boost.Multiprecision: the arithmetic of truth.
namespace shadefit {

/// A binary floating-point number of (at least) 50 decimal digits. Expression templates are off,
/// so that `a + b` is the scalar itself.
using Decimal50 =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;

template <unsigned Digits>
struct Scalar<boost::multiprecision::number<boost::multiprecision::cpp_bin_float<Digits>,
                                            boost::multiprecision::et_off>> {
  using T = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<Digits>,
                                          boost::multiprecision::et_off>;

  static T exp(const T& x) { return boost::multiprecision::exp(x); }
  static T exp2(const T& x) { return boost::multiprecision::exp(T(x * ln2())); }
  static T log(const T& x) { return boost::multiprecision::log(x); }
  static T log2(const T& x) { return log(x) / ln2(); }
  static T expm1(const T& x) { return boost::multiprecision::expm1(x); }
  static T log1p(const T& x) { return boost::multiprecision::log1p(x); }
  /// The series x^2 (-1/2 + x/3 - ..) if the subtraction would cancel more than two bits.
  static T log1p_remainder(const T& x) {
    if (abs(x) * 2 > 1) return log1p(x) - x;
    T term = -x * x;
    T sum = term / 2;
    for (int n = 3; abs(term) > abs(sum) * std::numeric_limits<T>::epsilon(); ++n) {
      term *= -x;
      sum += term / n;
    }
    return sum;
  }
  static T erfc(const T& x) { return boost::math::erfc(x); }
  static T sqrt(const T& x) { return boost::multiprecision::sqrt(x); }
  static T sin(const T& x) { return boost::multiprecision::sin(x); }
  static T cos(const T& x) { return boost::multiprecision::cos(x); }
  static T tan(const T& x) { return boost::multiprecision::tan(x); }
  /// By the arc tangent of two sides: near 1 Boost's own functions cancel.
  static T asin(const T& x) { return atan2(x, sqrt((1 - x) * (1 + x))); }
  static T acos(const T& x) { return 2 * atan2(sqrt(1 - x), sqrt(1 + x)); }
  static T atan(const T& x) { return boost::multiprecision::atan(x); }
  static T atan2(const T& y, const T& x) { return boost::multiprecision::atan2(y, x); }
  static T sinh(const T& x) { return boost::multiprecision::sinh(x); }
  static T cosh(const T& x) { return boost::multiprecision::cosh(x); }
  static T tanh(const T& x) { return boost::multiprecision::tanh(x); }
  static T erf(const T& x) { return boost::math::erf(x); }
  static T floor(const T& x) { return boost::multiprecision::floor(x); }
  static T power(const T& x, const T& p) {
    // Boost 1.74 calls itself without end if p is not a number and its sign is set.
    if (boost::multiprecision::isnan(p)) return p;
    return x == 0 && p > 0 ? T(0) : T(boost::multiprecision::pow(x, p));
  }
  static bool less(const T& a, const T& b) { return a < b; }
  static T select(bool condition, const T& a, const T& b) { return condition ? a : b; }
  static T min(const T& a, const T& b) { return b < a ? b : a; }
  static T max(const T& a, const T& b) { return a < b ? b : a; }
  static T integer(int n) { return T(n); }
  static T from_decimal(std::string_view decimal) { return T(std::string(decimal)); }
  static T pi() { return boost::math::constants::pi<T>(); }
  static T ln2() { return boost::math::constants::ln_two<T>(); }
};

/// In long double.
template <>
struct AlbedoIn<Decimal50> {
  static Decimal50 value(const Albedo& albedo, const Decimal50& c, const Decimal50& alpha) {
    return albedo_value(albedo, static_cast<long double>(c), static_cast<long double>(alpha));
  }
};

}  // namespace shadefit
