#pragma once

#include <cmath>
#include <concepts>
#include <utility>

#include "approx/exponent_bits.hpp"
#include "fit/proof/interval.hpp"
#include "fit/proof/interval_ends.hpp"
#include "fit/scalars/half.hpp"
#include "fit/scalars/jet.hpp"
#include "fit/scalars/multiprecision.hpp"

/// Exponents of the scalars of fit/: half, 50 digits, Jet and interval.
namespace shadefit {

/// The same as for float, with half's bits.
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

/// Its exponent range is larger than any formula needs.
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

/// An interval may contain several whole numbers; then its rest is [-1/2, 1/2] and slightly more. Near the
/// middle between two whole numbers both are used. So a result also covers exponents that float arithmetic
/// has rounded to the other side.
template <>
struct ExponentBits<Interval> {
  /// Three times the float rounding of the exponents A c - A of lobes up to A = 27. A proof that relies on it
  /// has to check that it is large enough.
  static constexpr double overlap = 0x1p-14;

  struct Whole {
    double lower, upper;
    bool is_cut() const { return lower != upper; }
  };
  static Whole whole_of(const Interval& x) {
    constexpr double reach = 0.5 + overlap;
    return {std::ceil(lower_end(Interval(x - Interval(reach)))),
            std::floor(upper_end(Interval(x + Interval(reach))))};
  }
  static SplitExponent<Interval, Whole> split(const Interval& x) {
    const Whole whole = whole_of(x);
    if (whole.is_cut()) return {span_of(-0.5 - overlap, 0.5 + overlap), whole};
    return {x - Interval(whole.lower), whole};
  }
  static Interval times_exp2(const Interval& p, const Whole& whole) {
    return p * Scalar<Interval>::hull(exp2(Interval(whole.lower)), exp2(Interval(whole.upper)));
  }
  /// Between two neighbouring whole numbers, each has its own rest next to the cut.
  template <class F>
  static Interval joined(const Interval& x, const F& f) {
    const Whole whole = whole_of(x);
    if (whole.upper - whole.lower != 1) return f(split(x));
    const double cut = whole.lower + 0.5, lower = lower_end(x), upper = upper_end(x);
    const auto part = [](double from, double to, double n) {
      return SplitExponent<Interval, Whole>{span_of(from, to) - Interval(n), {n, n}};
    };
    return Scalar<Interval>::hull(f(part(lower, std::fmin(upper, cut + overlap), whole.lower)),
                                  f(part(std::fmax(lower, cut - overlap), upper, whole.upper)));
  }
};

/// The whole number is constant between two jumps, so the derivative is that of the polynomial.
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
  /// At a jump there is no slope, so the derivative is enclosed by all numbers.
  template <class F>
  static Jet joined(const Jet& x, const F& f) requires std::same_as<T, Interval> {
    if (!ExponentBits<T>::whole_of(x.a).is_cut()) return f(split(x));
    Jet result(ExponentBits<T>::joined(x.a, f));
    for (int i = 0; i < N; ++i) result.v[i] = any_number();
    return result;
  }
};

}  // namespace shadefit
