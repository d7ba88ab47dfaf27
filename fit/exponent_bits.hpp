#pragma once

#include <cmath>

#include "approx/exponent_bits.hpp"
#include "fit/half.hpp"
#include "fit/interval.hpp"
#include "fit/interval_ends.hpp"
#include "fit/jet.hpp"
#include "fit/multiprecision.hpp"

/// Exponents of the scalars of fit/: half, 50 digits, Jet and interval.
namespace shadefit {

/// As of float, with half's bits.
template <>
struct ExponentBits<Eigen::half> {
  using half = Eigen::half;
  static SplitExponent<half> split(half x) {
    const half least(-15.0F), largest(16.0F), rounder(1536.0F);
    const half within = Scalar<half>::min(Scalar<half>::max(x, least), largest);
    const half shifted = within + rounder;
    return {within - (shifted - rounder), shifted};
  }
  static half times_exp2(half p, half shifted) {
    using Eigen::numext::uint16_t;
    const auto bits = Eigen::numext::bit_cast<uint16_t>(p);
    const auto exponent = static_cast<uint16_t>(Eigen::numext::bit_cast<uint16_t>(shifted) << 10);
    return Eigen::numext::bit_cast<half>(static_cast<uint16_t>(bits + exponent));
  }
};

/// Its exponents have no end that a formula meets.
template <unsigned Digits>
struct ExponentBits<boost::multiprecision::number<boost::multiprecision::cpp_bin_float<Digits>,
                                                  boost::multiprecision::et_off>> {
  using T = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<Digits>,
                                          boost::multiprecision::et_off>;
  static SplitExponent<T, int> split(const T& x) {
    const T whole = round(x);
    return {x - whole, static_cast<int>(whole)};
  }
  static T times_exp2(const T& p, int whole) { return ldexp(p, whole); }
};

/// The whole number does not vary: the derivative is that of the polynomial, as it is between two jumps.
template <class T, int N>
struct ExponentBits<ceres::Jet<T, N>> {
  using Jet = ceres::Jet<T, N>;
  using Whole = decltype(split_exponent(std::declval<T>()).whole);
  static SplitExponent<Jet, Whole> split(const Jet& x) {
    const auto parts = split_exponent(x.a);
    Jet rest(parts.rest);
    rest.v = x.v;
    return {rest, parts.whole};
  }
  static Jet times_exp2(const Jet& p, const Whole& whole) {
    Jet result(shadefit::times_exp2(p.a, whole));
    for (int i = 0; i < N; ++i) result.v[i] = p.v[i] * shadefit::times_exp2(integer<T>(1), whole);
    return result;
  }
};

/// An interval that a rounding cuts has more than one whole number, and its rest is all of [-1/2, 1/2].
template <>
struct ExponentBits<Interval> {
  struct Whole {
    double lower, upper;
  };
  static SplitExponent<Interval, Whole> split(const Interval& x) {
    const Whole whole{std::nearbyint(lower_end(x)), std::nearbyint(upper_end(x))};
    if (whole.lower == whole.upper) return {x - Interval(whole.lower), whole};
    return {span_of(-0.5, 0.5), whole};
  }
  static Interval times_exp2(const Interval& p, const Whole& whole) {
    return p * Scalar<Interval>::hull(exp2(Interval(whole.lower)), exp2(Interval(whole.upper)));
  }
};

}  // namespace shadefit
