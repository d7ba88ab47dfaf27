#pragma once

#include <bit>
#include <xsimd/xsimd.hpp>

#include <string_view>

#include "approx/exponent_bits.hpp"
#include "approx/scalar.hpp"

/// The adapter of xsimd's batches: a formula runs on a register of numbers as on one number.
///
/// Everything here carries the architecture in its type. A function that does not, compiled in a unit with
/// wider instructions, might be the copy that the linker keeps for all.
namespace shadefit {

/// With the functions of the timed forms. min and max exchange the arguments of xsimd's. If one is NaN, or
/// both are zeros, the instruction returns its second argument, but `Scalar<float>` returns its first.
template <class R, class A>
struct Scalar<xsimd::batch<R, A>> {
  using Real = R;
  using T = xsimd::batch<R, A>;
  using Condition = xsimd::batch_bool<R, A>;

  static T exp2(const T& x) { return xsimd::exp2(x); }
  static T log2(const T& x) { return xsimd::log2(x); }
  static T sqrt(const T& x) { return xsimd::sqrt(x); }
  static T power(const T& x, const T& p) { return xsimd::pow(x, p); }
  static Condition less(const T& a, const T& b) { return a < b; }
  static T min(const T& a, const T& b) { return xsimd::min(b, a); }
  static T max(const T& a, const T& b) { return xsimd::max(b, a); }
  static T integer(int n) { return of(static_cast<R>(n)); }
  static T from_decimal(std::string_view decimal) { return of(constant<R>(decimal)); }
  static T pi() { return of(std::numbers::pi_v<R>); }
  static T ln2() { return of(std::numbers::ln2_v<R>); }

  /// The same number in every lane.
  static T of(R value) { return T::broadcast(value); }
};

/// As for one float or double: see there.
template <class R, class A>
struct ExponentBits<xsimd::batch<R, A>> {
  using Range = ExponentLimits<R>;
  using T = xsimd::batch<R, A>;
  using Bits = xsimd::batch<typename BinaryLayout<R>::Bits, A>;

  static SplitExponent<T> split(const T& x) {
    const T least = T::broadcast(Range::least), largest = T::broadcast(Range::largest);
    const T rounder = T::broadcast(Range::rounder);
    const T within = Scalar<T>::min(Scalar<T>::max(x, least), largest);
    const T shifted = within + rounder;
    return {within - (shifted - rounder), shifted};
  }
  static T times_exp2(const T& p, const T& shifted) {
    const Bits exponent = std::bit_cast<Bits>(shifted) << Range::mantissa_bits;
    return std::bit_cast<T>(std::bit_cast<Bits>(p) + exponent);
  }
};

#ifdef __AVX512DQ__

/// AVX-512 has an instruction for rounding to a whole number and one for multiplying by a power of two. They
/// need no bounds: beyond the exponents of the format the result is infinity, subnormal or zero. The rest of
/// an infinite x is infinity - infinity = NaN, but VSCALEFPS returns infinity or 0 for NaN times 2 to an
/// infinite power. (Source: Intel 64 and IA-32 Architectures Software Developer's Manual, volume
/// 2, "VSCALEFPS", special cases.) NaN stays NaN.
template <>
struct ExponentBits<xsimd::batch<float, xsimd::avx512bw>> {
  using T = xsimd::batch<float, xsimd::avx512bw>;
  static SplitExponent<T> split(const T& x) {
    const __m512 whole = _mm512_roundscale_ps(x, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
    return {T(_mm512_sub_ps(x, whole)), T(whole)};
  }
  static T times_exp2(const T& p, const T& whole) { return T(_mm512_scalef_ps(p, whole)); }
};
template <>
struct ExponentBits<xsimd::batch<double, xsimd::avx512bw>> {
  using T = xsimd::batch<double, xsimd::avx512bw>;
  static SplitExponent<T> split(const T& x) {
    const __m512d whole = _mm512_roundscale_pd(x, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
    return {T(_mm512_sub_pd(x, whole)), T(whole)};
  }
  static T times_exp2(const T& p, const T& whole) { return T(_mm512_scalef_pd(p, whole)); }
};

#endif

}  // namespace shadefit
