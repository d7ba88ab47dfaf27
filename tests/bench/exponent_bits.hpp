#pragma once

#include "approx/exponent_bits.hpp"
#include "fit/scalars/half.hpp"
#include "fit/scalars/multiprecision.hpp"

/// Exponents of the scalars of fit/: half and 50 digits.
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

}  // namespace shadefit
