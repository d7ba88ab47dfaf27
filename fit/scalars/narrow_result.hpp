#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>

#include "fit/scalars/scalar_in_double.hpp"

/// Arithmetic in a binary format that is narrower than a double, on operands of any format.
namespace shadefit {

/// The formats by IEEE 754: significant bits, and the exponents of the least and the largest normal number.
struct HalfFormat {
  static constexpr std::string_view name = "half";
  static constexpr int digits = 11;
  static constexpr int least_exponent = -14;
  static constexpr int largest_exponent = 15;
};

/// The upper half of a float.
struct Bfloat16Format {
  static constexpr std::string_view name = "bfloat16";
  static constexpr int digits = 8;
  static constexpr int least_exponent = -126;
  static constexpr int largest_exponent = 127;
};

struct FloatFormat {
  static constexpr std::string_view name = "float";
  static constexpr int digits = 24;
  static constexpr int least_exponent = -126;
  static constexpr int largest_exponent = 127;
};

/// 2^n for a normal double.
constexpr double power_of_two(int n) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + n) << 52);
}

template <class Format>
inline constexpr double largest_of = (2 - power_of_two(1 - Format::digits)) *
                                     power_of_two(Format::largest_exponent);
template <class Format>
inline constexpr double least_normal_of = power_of_two(Format::least_exponent);
/// The distance of subnormals.
template <class Format>
inline constexpr double least_of = power_of_two(Format::least_exponent - Format::digits + 1);

/// The result of an operation in the format, or an operand that is not rounded (for example a float cosine).
/// Every operation is computed in double and rounded once. For operands of the format this is the format's
/// own arithmetic, correctly rounded, because a double has at least 2 p + 2 digits.
template <class Format>
class NarrowResult {
 public:
  NarrowResult() = default;
  /// The operand as it is: not rounded.
  explicit NarrowResult(double operand) : value_(operand) {}
  explicit operator double() const { return value_; }

  /// The nearest number of the format, ties to even.
  ///
  /// Numbers of the size of x are multiples of q = 2^(e-p+1), p the digits, where 2^e <= |x| < 2^(e+1), e at
  /// least that of the least normal number (subnormals lie as dense). |x/q| < 2^p is exact. Adding 3 * 2^51
  /// leaves no bits for a fraction: the sum is rounded to a whole number. From half a step beyond the largest
  /// number on, the result is infinity.
  static NarrowResult rounded(double x) {
    constexpr double shift = 0x1.8p52;
    constexpr int last = Format::digits - 1;
    const int biased = static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52 & 0x7ff);
    const int e = std::max(biased - 1023, Format::least_exponent);
    if (e > Format::largest_exponent) return NarrowResult(std::isnan(x) ? x : std::copysign(infinity, x));
    const double whole = (x * power_of_two(last - e) + shift) - shift;
    const double value = whole * power_of_two(e - last);
    const bool is_beyond = std::abs(value) > largest_of<Format>;
    return NarrowResult(is_beyond ? std::copysign(infinity, x) : std::copysign(value, x));
  }

  /// The number of the format next to x towards 0: x without the digits that it has too many. What overflows
  /// is the largest number.
  static NarrowResult cut_off(double x) {
    if (!std::isfinite(x)) return NarrowResult(x);
    const int e = std::max(std::ilogb(x), Format::least_exponent);
    const double q = std::ldexp(1.0, e - Format::digits + 1), value = std::trunc(x / q) * q;
    return NarrowResult(std::clamp(value, -largest_of<Format>, largest_of<Format>));
  }

  friend NarrowResult operator+(NarrowResult a, NarrowResult b) { return rounded(a.value_ + b.value_); }
  friend NarrowResult operator-(NarrowResult a, NarrowResult b) { return rounded(a.value_ - b.value_); }
  friend NarrowResult operator*(NarrowResult a, NarrowResult b) { return rounded(a.value_ * b.value_); }
  friend NarrowResult operator/(NarrowResult a, NarrowResult b) { return rounded(a.value_ / b.value_); }
  friend NarrowResult operator-(NarrowResult a) { return NarrowResult(-a.value_); }
  friend bool operator<(NarrowResult a, NarrowResult b) { return a.value_ < b.value_; }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  double value_ = 0;
};

/// For exp, exp2, log and log2 of every half and every bfloat16 this is the correctly rounded result: none is
/// so near a tie that the error of the double could move it (tests/fit/scalars/narrow_result_test.cpp).
template <class Format>
struct Scalar<NarrowResult<Format>> : ScalarInDouble<NarrowResult<Format>, NarrowResult<Format>::rounded> {};

/// Half arithmetic on operands of any format; on halves it is that of Eigen::half.
using HalfResult = NarrowResult<HalfFormat>;

}  // namespace shadefit
