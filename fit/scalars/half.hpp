#pragma once

#include <Eigen/Core>
#include <cmath>
#include <concepts>
#include <limits>

#include "fit/scalars/scalar_in_double.hpp"

/// The adapter of Eigen::half, the 16-bit format of mobile GPUs.
namespace shadefit {

/// The half nearest to x (ties to even), rounded once. Eigen rounds a double through float, which rounds
/// twice; a float rounded to odd (an inexact result with an even last bit moves to its neighbour) makes the
/// second rounding harmless.
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

/// A double rounded to half, float or double, once.
template <class T>
T rounded_to(double x) {
  if constexpr (std::same_as<T, Eigen::half>) {
    return round_to_half(x);
  } else {
    return static_cast<T>(x);
  }
}

/// A number of any of these formats as a double, exactly.
template <class T>
double widened(T x) {
  return static_cast<double>(x);
}

template <>
struct Scalar<Eigen::half> : ScalarInDouble<Eigen::half, round_to_half> {};

}  // namespace shadefit
