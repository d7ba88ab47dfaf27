#pragma once

#include <ceres/jet.h>

#include <concepts>

#include "approx/scalar.hpp"

/// The adapter of ceres::Jet: a value and its derivatives. A Jet of Jets carries second derivatives.
namespace shadefit {

/// Each function of the vocabulary: its value and the chain rule. Both use the vocabulary of the Jet's own
/// scalar, so nested and wide Jets work too (Ceres 2.1's pow does not compile over multiprecision).
template <class T, int N>
struct Scalar<ceres::Jet<T, N>> {
  using Jet = ceres::Jet<T, N>;
  using Derivatives = Eigen::Matrix<T, N, 1>;

  static Jet exp(const Jet& x) {
    const T value = shadefit::exp(x.a);
    return Jet(value, value * x.v);
  }
  static Jet exp2(const Jet& x) {
    const T value = shadefit::exp2(x.a);
    return Jet(value, (value * shadefit::ln2<T>()) * x.v);
  }
  static Jet log(const Jet& x) { return Jet(shadefit::log(x.a), chain(one() / x.a, x.v)); }
  static Jet log2(const Jet& x) {
    return Jet(shadefit::log2(x.a), chain(one() / (x.a * shadefit::ln2<T>()), x.v));
  }
  /// exp(x) = expm1(x) + 1 loses digits for x << 0. But there the derivative is negligible beside 1, to which
  /// it is always added: a second exponential would gain nothing.
  static Jet expm1(const Jet& x) {
    const T value = shadefit::expm1(x.a);
    return Jet(value, (value + one()) * x.v);
  }
  static Jet log1p(const Jet& x) { return Jet(shadefit::log1p(x.a), chain(one() / (one() + x.a), x.v)); }
  /// d/dx (log1p(x) - x) = -x / (1 + x)
  static Jet log1p_remainder(const Jet& x) {
    return Jet(shadefit::log1p_remainder(x.a), chain(-x.a / (one() + x.a), x.v));
  }
  static Jet erfc(const Jet& x) { return Jet(shadefit::erfc(x.a), chain(-bell(x.a), x.v)); }
  static Jet sqrt(const Jet& x) {
    const T value = shadefit::sqrt(x.a);
    return Jet(value, chain(one() / (value + value), x.v));
  }
  static Jet sin(const Jet& x) { return Jet(shadefit::sin(x.a), shadefit::cos(x.a) * x.v); }
  static Jet cos(const Jet& x) { return Jet(shadefit::cos(x.a), -shadefit::sin(x.a) * x.v); }
  static Jet tan(const Jet& x) {
    const T value = shadefit::tan(x.a);
    return Jet(value, (one() + value * value) * x.v);
  }
  static Jet asin(const Jet& x) { return Jet(shadefit::asin(x.a), chain(arc_slope(x.a), x.v)); }
  static Jet acos(const Jet& x) { return Jet(shadefit::acos(x.a), chain(-arc_slope(x.a), x.v)); }
  static Jet atan(const Jet& x) { return Jet(shadefit::atan(x.a), chain(one() / (one() + x.a * x.a), x.v)); }
  /// d atan2(y, x) = (x dy - y dx)/(x^2 + y^2)
  static Jet atan2(const Jet& y, const Jet& x) {
    const T square = x.a * x.a + y.a * y.a;
    Jet result(shadefit::atan2(y.a, x.a));
    result.v = chain(x.a / square, y.v) - chain(y.a / square, x.v);
    return result;
  }
  static Jet sinh(const Jet& x) { return Jet(shadefit::sinh(x.a), shadefit::cosh(x.a) * x.v); }
  static Jet cosh(const Jet& x) { return Jet(shadefit::cosh(x.a), shadefit::sinh(x.a) * x.v); }
  /// 1/cosh^2, where 1 - tanh^2 would cancel.
  static Jet tanh(const Jet& x) {
    const T inverse = one() / shadefit::cosh(x.a);
    return Jet(shadefit::tanh(x.a), (inverse * inverse) * x.v);
  }
  static Jet erf(const Jet& x) { return Jet(shadefit::erf(x.a), chain(bell(x.a), x.v)); }
  static Jet floor(const Jet& x) { return Jet(shadefit::floor(x.a)); }
  /// d(x^p) = p x^(p-1) dx + x^p log(x) dp. At x = 0 the first factor is 0 for p > 1 and infinite for p < 1,
  /// and the second term is 0 for p > 0: neither 0 * infinity may make it NaN.
  static Jet power(const Jet& x, const Jet& p) {
    const T value = shadefit::power(x.a, p.a);
    Jet result(value);
    if (!is_zero(p.a)) result.v += chain(p.a * shadefit::power(x.a, T(p.a - one())), x.v);
    if (!is_zero(value)) result.v += chain(value * shadefit::log(x.a), p.v);
    return result;
  }
  static auto less(const Jet& a, const Jet& b) { return shadefit::less(a.a, b.a); }
  template <class Condition>
  static Jet select(const Condition& condition, const Jet& a, const Jet& b) {
    Jet result(shadefit::select(condition, a.a, b.a));
    for (int i = 0; i < N; ++i) result.v[i] = shadefit::select(condition, a.v[i], b.v[i]);
    return result;
  }
  static Jet min(const Jet& a, const Jet& b) { return select(less(b, a), b, a); }
  static Jet max(const Jet& a, const Jet& b) { return select(less(a, b), b, a); }
  static Jet integer(int n) { return Jet(shadefit::integer<T>(n)); }
  static Jet from_decimal(std::string_view decimal) { return Jet(shadefit::constant<T>(decimal)); }
  static Jet pi() { return Jet(shadefit::pi<T>()); }
  static Jet ln2() { return Jet(shadefit::ln2<T>()); }

  /// slope * v, but an infinite slope times a zero derivative is zero: what does not vary stays constant.
  static Derivatives chain(const T& slope, const Derivatives& v) {
    Derivatives result;
    for (int i = 0; i < N; ++i) result[i] = is_zero(v[i]) ? shadefit::integer<T>(0) : T(slope * v[i]);
    return result;
  }

 private:
  static T one() { return shadefit::integer<T>(1); }

  /// 1/sqrt(1 - x^2), the slope of asin.
  static T arc_slope(const T& x) { return one() / shadefit::sqrt((one() - x) * (one() + x)); }
  /// 2/sqrt(pi) exp(-x^2), the slope of erf.
  static T bell(const T& x) {
    return shadefit::integer<T>(2) / shadefit::sqrt(shadefit::pi<T>()) * shadefit::exp(-x * x);
  }

  /// Whether a value and all its derivatives are zero; ceres::Jet's == compares values only. A scalar whose
  /// == does not return a bool has its own overload.
  template <class U>
  static bool is_zero(const U& x) {
    if constexpr (requires { Scalar<U>::is_zero(x); }) {
      return Scalar<U>::is_zero(x);
    } else {
      return x == shadefit::integer<U>(0);
    }
  }
  template <class U, int M>
  static bool is_zero(const ceres::Jet<U, M>& x) {
    for (int i = 0; i < M; ++i) {
      if (!is_zero(x.v[i])) return false;
    }
    return is_zero(x.a);
  }
};

/// Whether a scalar is a Jet.
template <class T>
inline constexpr bool is_jet = false;
template <class T, int N>
inline constexpr bool is_jet<ceres::Jet<T, N>> = true;

/// A value as the scalar P: itself, a constant Jet (of Jets), or the conversion of P (an interval holds a
/// double exactly).
template <class P, class T>
P lift(const T& value) {
  if constexpr (std::same_as<P, T>) {
    return value;
  } else if constexpr (is_jet<P>) {
    return P(lift<typename P::Scalar>(value));
  } else {
    return static_cast<P>(value);
  }
}

}  // namespace shadefit
