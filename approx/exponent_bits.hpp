#pragma once

#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>

#include "approx/scalar.hpp"

/// Splitting off and multiplying by powers of two: what exp2 by a polynomial needs of its scalar in addition
/// to the vocabulary.
namespace shadefit {

/// The customisation point: what a scalar must offer in addition to `Scalar`.
/// - `split(x)`: x, clamped to the exponents of the format, as a whole number and a rest, |rest| <= 1/2;
/// - `times_exp2(p, whole)`: p 2^whole, with `whole` in the representation that `split` returns.
template <class T>
struct ExponentBits;

/// x = whole + rest.
template <class T, class Whole = T>
struct SplitExponent {
  T rest;
  Whole whole;
};

/// x as the nearest whole number (ties to even) and the rest.
inline constexpr auto split_exponent = []<class T>(const T& x) { return ExponentBits<T>::split(x); };
/// p 2^whole for a p in [1/2, 2).
inline constexpr auto times_exp2 = []<class T, class Whole>(const T& p, const Whole& whole) -> T {
  return ExponentBits<T>::times_exp2(p, whole);
};

/// How a binary format of 32 or 64 bits is laid out.
template <std::floating_point T>
struct BinaryLayout;
template <>
struct BinaryLayout<float> {
  using Bits = std::uint32_t;
};
template <>
struct BinaryLayout<double> {
  using Bits = std::uint64_t;
};

/// Constants that follow from the layout, for scalars and for batches.
template <std::floating_point T>
struct ExponentLimits {
  /// The bits below the exponent.
  static constexpr int mantissa_bits = std::numeric_limits<T>::digits - 1;
  /// 2^least is the power below the least normal one: its exponent bits are zero.
  static constexpr T least = std::numeric_limits<T>::min_exponent - 2;
  /// 2^largest is infinity: its exponent bits are all ones.
  static constexpr T largest = std::numeric_limits<T>::max_exponent;
  /// 3/2 2^mantissa_bits. The numbers around it are whole, so adding it rounds x to a whole number and leaves
  /// that number in the lowest bits. The factor 3/2 makes this work for both signs.
  static constexpr T rounder = T(3) * static_cast<T>(std::uint64_t{1} << (mantissa_bits - 1));
};

/// float and double: rounding by an addition, the power of two by adding to the bits of the exponent.
///
/// Below the least normal number 2^m the result falls linearly from 2^m at x = m to 0 at x = m - 1 and stays
/// 0. Its error never exceeds 2^(m-1), and no subnormal is multiplied. From `largest` on the result is
/// infinity. NaN stays NaN (except perhaps one with a payload in its lowest bits, which the hardware does not
/// produce).
template <std::floating_point T>
requires requires {
  typename BinaryLayout<T>::Bits;
}
struct ExponentBits<T> {
  using Range = ExponentLimits<T>;
  using Bits = typename BinaryLayout<T>::Bits;

  static SplitExponent<T> split(T x) {
    const T within = Scalar<T>::min(Scalar<T>::max(x, Range::least), Range::largest);
    const T shifted = within + Range::rounder;
    return {within - (shifted - Range::rounder), shifted};
  }
  static T times_exp2(T p, T shifted) {
    return std::bit_cast<T>(
        static_cast<Bits>(std::bit_cast<Bits>(p) + (std::bit_cast<Bits>(shifted) << Range::mantissa_bits)));
  }
};

/// long double has another layout, so the standard library splits it.
template <>
struct ExponentBits<long double> {
  static SplitExponent<long double, int> split(long double x) {
    using Range = ExponentLimits<double>;
    // beyond every exponent of the format, but small enough for an int
    constexpr auto beyond = static_cast<long double>(32 * Range::largest);
    const long double within = Scalar<long double>::min(Scalar<long double>::max(x, -beyond), beyond);
    const long double whole = std::nearbyint(within);
    return {within - whole, std::isnan(whole) ? 0 : static_cast<int>(whole)};
  }
  static long double times_exp2(long double p, int whole) { return std::ldexp(p, whole); }
};

}  // namespace shadefit
