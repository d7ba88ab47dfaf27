#pragma once

#include <array>

#include "fit/scalars/multiprecision.hpp"

/// Vectors of 50 digits.
namespace shadefit::testing {

using Vector = std::array<Decimal50, 3>;

inline Decimal50 dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace shadefit::testing
