#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string_view>

#include "approx/exponent_bits.hpp"
#include "approx/scalar.hpp"
#include "fit/scalars/albedo_in.hpp"

/// Two doubles as one scalar: every 64-bit machine has registers of this size. The nodes of a quadrature are
/// computed two at a time.
namespace shadefit {

/// The operations are those of a double in each lane, with the same rounding; exponentials are computed in
/// both lanes together by a power series; other functions lane by lane by the C++ standard library.
struct TwoLanes {
  using Scalar = double;  ///< in each lane
  static constexpr std::size_t size = 2;
  using Register = double __attribute__((vector_size(16)));
  using Bits = std::uint64_t __attribute__((vector_size(16)));

  Register lanes;

  TwoLanes() = default;
  TwoLanes(double both) : lanes{both, both} {}
  TwoLanes(double first, double second) : lanes{first, second} {}
  explicit TwoLanes(Register r) : lanes(r) {}
  template <std::same_as<long double> Wide>
  explicit TwoLanes(Wide both) : TwoLanes(static_cast<double>(both)) {}

  double operator[](std::size_t lane) const { return lanes[lane]; }

  TwoLanes operator-() const { return TwoLanes(-lanes); }
  TwoLanes& operator+=(const TwoLanes& b) { return *this = *this + b; }
  TwoLanes& operator-=(const TwoLanes& b) { return *this = *this - b; }
  TwoLanes& operator*=(const TwoLanes& b) { return *this = *this * b; }
  TwoLanes& operator/=(const TwoLanes& b) { return *this = *this / b; }
  friend TwoLanes operator+(const TwoLanes& a, const TwoLanes& b) { return TwoLanes(a.lanes + b.lanes); }
  friend TwoLanes operator-(const TwoLanes& a, const TwoLanes& b) { return TwoLanes(a.lanes - b.lanes); }
  friend TwoLanes operator*(const TwoLanes& a, const TwoLanes& b) { return TwoLanes(a.lanes * b.lanes); }
  friend TwoLanes operator/(const TwoLanes& a, const TwoLanes& b) { return TwoLanes(a.lanes / b.lanes); }
};

/// The numbers T that are computed with at once: one.
template <class T>
struct SideBySide {
  using Type = T;
  static constexpr std::size_t size = 1;
  static T joined(const std::array<T, 1>& x) { return x[0]; }
  static T lane(const T& x, std::size_t) { return x; }
  static T sum(const T& x) { return x; }
};

/// Of doubles two.
template <>
struct SideBySide<double> {
  using Type = TwoLanes;
  static constexpr std::size_t size = TwoLanes::size;
  static TwoLanes joined(const std::array<double, 2>& x) { return {x[0], x[1]}; }
  static double lane(const TwoLanes& x, std::size_t i) { return x[i]; }
  static double sum(const TwoLanes& x) { return x[0] + x[1]; }
};

/// As of one double: see there.
template <>
struct ExponentBits<TwoLanes> {
  using Range = ExponentLimits<double>;

  static SplitExponent<TwoLanes> split(const TwoLanes& x) {
    const TwoLanes::Register least{Range::least, Range::least}, largest{Range::largest, Range::largest};
    const auto above = x.lanes < least ? least : x.lanes;
    const TwoLanes within(largest < above ? largest : above);
    const TwoLanes shifted = within + Range::rounder;
    return {within - (shifted - Range::rounder), shifted};
  }
  static TwoLanes times_exp2(const TwoLanes& p, const TwoLanes& shifted) {
    const auto exponent = std::bit_cast<TwoLanes::Bits>(shifted.lanes) << Range::mantissa_bits;
    return TwoLanes(std::bit_cast<TwoLanes::Register>(std::bit_cast<TwoLanes::Bits>(p.lanes) + exponent));
  }
};

namespace detail {

/// 1/2!, 1/3! .. 1/13!.
inline constexpr auto reciprocal_factorials = [] {
  std::array<double, 12> r{};
  double factorial = 1;
  for (std::size_t i = 0; i < r.size(); ++i) {
    factorial *= static_cast<double>(i + 2);
    r[i] = 1 / factorial;
  }
  return r;
}();

/// e^r - 1 for |r| <= log(2)/2 by its power series up to r^13: the next term is 1.3e-17 of the result. Even
/// and odd terms are summed side by side: two chains of half the length. Inlined, those of neighbouring nodes
/// do not wait for each other.
template <class T>
[[gnu::always_inline]] inline T expm1_of_rest(const T& r) {
  constexpr auto& c = reciprocal_factorials;
  const T r2 = r * r;
  T even = c[10], odd = c[11];
  for (std::size_t i = 10; i > 0; i -= 2) {
    even = even * r2 + T(c[i - 2]);
    odd = odd * r2 + T(c[i - 1]);
  }
  return r + r2 * (even + r * odd);
}

/// x as n log(2) + rest, for |x| <= 745. Of log(2) the upper part has 32 bits, so that n times it is exact.
struct SplitByLog2 {
  TwoLanes rest;
  TwoLanes whole;  ///< n as `times_exp2` wants it

  explicit SplitByLog2(const TwoLanes& x) {
    constexpr double upper = 0x1.62e42fee00000p-1, lower = 0x1.a39ef35793c76p-33;
    constexpr double rounder = ExponentLimits<double>::rounder;
    whole = x * std::numbers::log2e + rounder;
    const TwoLanes n = whole - rounder;
    rest = (x - n * upper) - n * lower;
  }
};

/// From where on an exponential is not a number of the format, log(2^1024), below it no normal one,
/// log(2^-1022), and beside 1 nothing, log(2^-54): each with a little room, so that 2^n is a power of the
/// format.
inline constexpr double overflow = 709.75, least_normal = -708.375, vanishing = -37.5;

/// An exponential of x: in a lane where x is below `end` its limit there, where it overflows infinity.
inline TwoLanes bounded(const TwoLanes& x, double end, double limit, const TwoLanes& value) {
  const auto above = x.lanes < TwoLanes(end).lanes ? TwoLanes(limit).lanes : value.lanes;
  const TwoLanes infinite(std::numeric_limits<double>::infinity());
  return TwoLanes(x.lanes > TwoLanes(overflow).lanes ? infinite.lanes : above);
}

}  // namespace detail

/// The adapter of two lanes.
template <>
struct Scalar<TwoLanes> {
  using T = TwoLanes;
  struct Condition {
    bool first, second;
  };

  /// 0 where it is below the normal numbers.
  static T exp(const T& x) {
    const detail::SplitByLog2 s(x);
    const T value = times_exp2(T(1) + detail::expm1_of_rest(s.rest), s.whole);
    return detail::bounded(x, detail::least_normal, 0, value);
  }
  static T exp2(const T& x) {
    const auto s = split_exponent(x);
    return times_exp2(T(1) + detail::expm1_of_rest(s.rest * ln2()), s.whole);
  }
  /// 2^n e^r - 1 = 2^n (e^r - 1) + (2^n - 1); -1 from where it rounds to that.
  static T expm1(const T& x) {
    const detail::SplitByLog2 s(x);
    const T scale = times_exp2(T(1), s.whole);
    const T value = scale * detail::expm1_of_rest(s.rest) + (scale - T(1));
    return detail::bounded(x, detail::vanishing, -1, value);
  }
  static T log(const T& x) { return {std::log(x[0]), std::log(x[1])}; }
  static T log2(const T& x) { return {std::log2(x[0]), std::log2(x[1])}; }
  static T log1p(const T& x) { return {std::log1p(x[0]), std::log1p(x[1])}; }
  static T erfc(const T& x) { return {std::erfc(x[0]), std::erfc(x[1])}; }
  static T sqrt(const T& x) { return {std::sqrt(x[0]), std::sqrt(x[1])}; }
  static T sin(const T& x) { return {std::sin(x[0]), std::sin(x[1])}; }
  static T cos(const T& x) { return {std::cos(x[0]), std::cos(x[1])}; }
  static T tan(const T& x) { return {std::tan(x[0]), std::tan(x[1])}; }
  static T asin(const T& x) { return {std::asin(x[0]), std::asin(x[1])}; }
  static T acos(const T& x) { return {std::acos(x[0]), std::acos(x[1])}; }
  static T atan(const T& x) { return {std::atan(x[0]), std::atan(x[1])}; }
  static T atan2(const T& y, const T& x) { return {std::atan2(y[0], x[0]), std::atan2(y[1], x[1])}; }
  static T sinh(const T& x) { return {std::sinh(x[0]), std::sinh(x[1])}; }
  static T cosh(const T& x) { return {std::cosh(x[0]), std::cosh(x[1])}; }
  static T tanh(const T& x) { return {std::tanh(x[0]), std::tanh(x[1])}; }
  static T erf(const T& x) { return {std::erf(x[0]), std::erf(x[1])}; }
  static T floor(const T& x) { return {std::floor(x[0]), std::floor(x[1])}; }
  static T power(const T& x, const T& p) { return {std::pow(x[0], p[0]), std::pow(x[1], p[1])}; }
  static T log1p_remainder(const T& x) {
    const double largest = std::max(std::abs(x[0]), std::abs(x[1]));
    if (largest <= 0.5) {
      const T r = x / (2 + x), r2 = r * r;
      return detail::remainder_by_series<double, T, T>(x, r, r2, std::max(r2[0], r2[1]));
    }
    return {Scalar<double>::log1p_remainder(x[0]), Scalar<double>::log1p_remainder(x[1])};
  }
  static Condition less(const T& a, const T& b) { return {a[0] < b[0], a[1] < b[1]}; }
  static T select(const Condition& is_so, const T& a, const T& b) {
    return {is_so.first ? a[0] : b[0], is_so.second ? a[1] : b[1]};
  }
  /// Where both lanes agree one branch is enough.
  template <class A, class B>
  static T choose(const Condition& is_so, const A& a, const B& b) {
    if (is_so.first != is_so.second) return select(is_so, a(), b());
    return is_so.first ? a() : b();
  }
  static T min(const T& a, const T& b) { return select(less(b, a), b, a); }
  static T max(const T& a, const T& b) { return select(less(a, b), b, a); }
  static T integer(int n) { return static_cast<double>(n); }
  static T from_decimal(std::string_view decimal) { return constant<double>(decimal); }
  static T pi() { return shadefit::pi<double>(); }
  static T ln2() { return shadefit::ln2<double>(); }
  static bool is_zero(const T& x) { return x[0] == 0 && x[1] == 0; }
};

template <>
struct AlbedoIn<TwoLanes> {
  static TwoLanes value(const Albedo& albedo, const TwoLanes& c, const TwoLanes& alpha) {
    return {albedo_value(albedo, c[0], alpha[0]), albedo_value(albedo, c[1], alpha[1])};
  }
};

}  // namespace shadefit

template <>
struct Eigen::NumTraits<shadefit::TwoLanes> : Eigen::NumTraits<double> {
  using Real = shadefit::TwoLanes;
  using NonInteger = shadefit::TwoLanes;
  using Nested = shadefit::TwoLanes;
  using Literal = shadefit::TwoLanes;
};
