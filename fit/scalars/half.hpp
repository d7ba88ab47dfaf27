#pragma once

#include <Eigen/Core>
#include <concepts>

#include "fit/scalars/narrow_result.hpp"

/// The adapter of Eigen::half, the 16-bit format of mobile GPUs.
namespace shadefit {

/// The half nearest to x (ties to even), rounded once. Eigen rounds a double through float, which rounds
/// twice.
inline Eigen::half round_to_half(double x) {
  return Eigen::half(static_cast<float>(static_cast<double>(HalfResult::rounded(x))));
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
