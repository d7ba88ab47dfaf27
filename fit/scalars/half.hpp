#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>

#include "approx/scalar.hpp"

/// The adapter of Eigen::half, the 16-bit format that a mobile GPU computes in.
namespace shadefit {

/// The half nearest to x (ties to even), rounded once. Eigen rounds a double through float, which rounds
/// twice; a float rounded to odd (an inexact result with an even last bit moves to its neighbour) makes the
/// second one harmless.
inline Eigen::half round_to_half(double x) {
  auto narrow = static_cast<float>(x);
  const bool even = (Eigen::numext::bit_cast<Eigen::numext::uint32_t>(narrow) & 1u) == 0;
  if (std::isfinite(narrow) && static_cast<double>(narrow) != x && even) {
    const float towards = x > static_cast<double>(narrow) ? std::numeric_limits<float>::infinity()
                                                          : -std::numeric_limits<float>::infinity();
    narrow = std::nextafterf(narrow, towards);
  }
  return Eigen::half(narrow);
}

/// Each function is evaluated in double and rounded once: what the best hardware of that format could return.
template <>
struct Scalar<Eigen::half> {
  using half = Eigen::half;

  static half exp(half x) { return round_to_half(std::exp(wide(x))); }
  static half exp2(half x) { return round_to_half(std::exp2(wide(x))); }
  static half log(half x) { return round_to_half(std::log(wide(x))); }
  static half log2(half x) { return round_to_half(std::log2(wide(x))); }
  static half expm1(half x) { return round_to_half(std::expm1(wide(x))); }
  static half log1p(half x) { return round_to_half(std::log1p(wide(x))); }
  static half log1p_remainder(half x) { return round_to_half(Scalar<double>::log1p_remainder(wide(x))); }
  static half erfc(half x) { return round_to_half(std::erfc(wide(x))); }
  static half sqrt(half x) { return round_to_half(std::sqrt(wide(x))); }
  static half sin(half x) { return round_to_half(std::sin(wide(x))); }
  static half cos(half x) { return round_to_half(std::cos(wide(x))); }
  static half atan(half x) { return round_to_half(std::atan(wide(x))); }
  static half power(half x, half p) { return round_to_half(std::pow(wide(x), wide(p))); }
  static bool less(half a, half b) { return a < b; }
  static half select(bool condition, half a, half b) { return condition ? a : b; }
  static half min(half a, half b) { return b < a ? b : a; }
  static half max(half a, half b) { return a < b ? b : a; }
  static half integer(int n) { return half(static_cast<float>(n)); }
  static half from_decimal(std::string_view decimal) { return round_to_half(constant<double>(decimal)); }
  static half pi() { return round_to_half(Scalar<double>::pi()); }
  static half ln2() { return round_to_half(Scalar<double>::ln2()); }

 private:
  static double wide(half x) { return static_cast<double>(static_cast<float>(x)); }
};

}  // namespace shadefit
