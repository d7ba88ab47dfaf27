#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "approx/scalar.hpp"

/// Half arithmetic on operands that need not be halves.
namespace shadefit {

/// The result of an operation in half, or an operand as it came (a float cosine, say): every operation is
/// computed in double and its result rounded once to half. On halves it is the arithmetic of Eigen::half.
class HalfResult {
 public:
  HalfResult() = default;
  /// The operand as it is: not rounded.
  explicit HalfResult(double operand) : value_(operand) {}
  explicit operator double() const { return value_; }

  /// That number in half, ties to even: what `round_to_half` gives, at a tenth of its time.
  ///
  /// Halves of the size of x are multiples of q = 2^(e-10), where 2^e <= |x| < 2^(e+1), e >= -14 (subnormals
  /// lie as dense as the least normal numbers). |x/q| < 2^11 is exact, and adding 3 * 2^51 to it leaves no
  /// bits for a fraction: the sum is rounded to a whole number. From 65520 on, half a step beyond the largest
  /// half, it is infinity.
  static HalfResult rounded(double x) {
    constexpr double shift = 0x1.8p52;
    const int biased = static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52 & 0x7ff);
    const int e = std::max(biased - 1023, -14);
    if (e > 15) return HalfResult(std::isnan(x) ? x : std::copysign(infinity, x));
    const auto power_of_two = [](int n) {
      return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + n) << 52);
    };
    const double whole = (x * power_of_two(10 - e) + shift) - shift;
    const double value = whole * power_of_two(e - 10);
    return HalfResult(std::abs(value) > 65504 ? std::copysign(infinity, x) : std::copysign(value, x));
  }

  friend HalfResult operator+(HalfResult a, HalfResult b) { return rounded(a.value_ + b.value_); }
  friend HalfResult operator-(HalfResult a, HalfResult b) { return rounded(a.value_ - b.value_); }
  friend HalfResult operator*(HalfResult a, HalfResult b) { return rounded(a.value_ * b.value_); }
  friend HalfResult operator/(HalfResult a, HalfResult b) { return rounded(a.value_ / b.value_); }
  friend HalfResult operator-(HalfResult a) { return HalfResult(-a.value_); }
  friend bool operator<(HalfResult a, HalfResult b) { return a.value_ < b.value_; }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  double value_ = 0;
};

/// Each function is evaluated in double and rounded once, as for Eigen::half.
template <>
struct Scalar<HalfResult> {
  using T = HalfResult;

  static T exp(T x) { return T::rounded(std::exp(wide(x))); }
  static T exp2(T x) { return T::rounded(std::exp2(wide(x))); }
  static T log(T x) { return T::rounded(std::log(wide(x))); }
  static T log2(T x) { return T::rounded(std::log2(wide(x))); }
  static T expm1(T x) { return T::rounded(std::expm1(wide(x))); }
  static T log1p(T x) { return T::rounded(std::log1p(wide(x))); }
  static T log1p_remainder(T x) { return T::rounded(Scalar<double>::log1p_remainder(wide(x))); }
  static T sqrt(T x) { return T::rounded(std::sqrt(wide(x))); }
  static T sin(T x) { return T::rounded(std::sin(wide(x))); }
  static T cos(T x) { return T::rounded(std::cos(wide(x))); }
  static T atan(T x) { return T::rounded(std::atan(wide(x))); }
  static T erfc(T x) { return T::rounded(std::erfc(wide(x))); }
  static T power(T x, T p) { return T::rounded(std::pow(wide(x), wide(p))); }
  static bool less(T a, T b) { return a < b; }
  static T select(bool condition, T a, T b) { return condition ? a : b; }
  static T min(T a, T b) { return b < a ? b : a; }
  static T max(T a, T b) { return a < b ? b : a; }
  static T integer(int n) { return T::rounded(n); }
  static T from_decimal(std::string_view decimal) { return T::rounded(constant<double>(decimal)); }
  static T pi() { return T::rounded(Scalar<double>::pi()); }
  static T ln2() { return T::rounded(Scalar<double>::ln2()); }

 private:
  static double wide(T x) { return static_cast<double>(x); }
};

}  // namespace shadefit
