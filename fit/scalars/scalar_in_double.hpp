#pragma once

#include <cmath>
#include <string_view>

#include "approx/scalar.hpp"

namespace shadefit {

/// The adapter of a number T that is narrower than a double. Each function is evaluated in double and rounded
/// once, by `round`: the best possible result of hardware with that format.
template <class T, T (*round)(double)>
struct ScalarInDouble {
  static T exp(T x) { return round(std::exp(wide(x))); }
  static T exp2(T x) { return round(std::exp2(wide(x))); }
  static T log(T x) { return round(std::log(wide(x))); }
  static T log2(T x) { return round(std::log2(wide(x))); }
  static T expm1(T x) { return round(std::expm1(wide(x))); }
  static T log1p(T x) { return round(std::log1p(wide(x))); }
  static T log1p_remainder(T x) { return round(Scalar<double>::log1p_remainder(wide(x))); }
  static T erfc(T x) { return round(std::erfc(wide(x))); }
  static T sqrt(T x) { return round(std::sqrt(wide(x))); }
  static T sin(T x) { return round(std::sin(wide(x))); }
  static T cos(T x) { return round(std::cos(wide(x))); }
  static T tan(T x) { return round(std::tan(wide(x))); }
  static T asin(T x) { return round(std::asin(wide(x))); }
  static T acos(T x) { return round(std::acos(wide(x))); }
  static T atan(T x) { return round(std::atan(wide(x))); }
  static T atan2(T y, T x) { return round(std::atan2(wide(y), wide(x))); }
  static T sinh(T x) { return round(std::sinh(wide(x))); }
  static T cosh(T x) { return round(std::cosh(wide(x))); }
  static T tanh(T x) { return round(std::tanh(wide(x))); }
  static T erf(T x) { return round(std::erf(wide(x))); }
  static T floor(T x) { return round(std::floor(wide(x))); }
  static T power(T x, T p) { return round(std::pow(wide(x), wide(p))); }
  static bool less(T a, T b) { return a < b; }
  static T select(bool condition, T a, T b) { return condition ? a : b; }
  static T min(T a, T b) { return b < a ? b : a; }
  static T max(T a, T b) { return a < b ? b : a; }
  static T integer(int n) { return round(n); }
  static T from_decimal(std::string_view decimal) { return round(constant<double>(decimal)); }
  static T pi() { return round(Scalar<double>::pi()); }
  static T ln2() { return round(Scalar<double>::ln2()); }

 private:
  static double wide(T x) { return static_cast<double>(x); }
};

}  // namespace shadefit
