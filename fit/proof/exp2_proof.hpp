#pragma once

#include <string_view>
#include <vector>

#include "approx/exp2_polynomial.hpp"

/// What is proven of the polynomials for exp2.
namespace shadefit {

/// A polynomial and the bounds of its error.
struct Exp2Bounds {
  std::string_view format;  ///< "float" or "double"
  const Exp2Coefficients* polynomial;
  /// The largest |p(r)/2^r - 1| on [-1/2, 1/2] lies in [lower, upper]: of the digits or of the
  /// machine's numbers for them, whichever is worse.
  double lower = 0, upper = 0;
  /// What evaluating p in that format, every operation rounded, adds at most, relative to p.
  double rounding = 0;
};

/// All of them by format and degree, proven now.
std::vector<Exp2Bounds> exp2_bounds();

}  // namespace shadefit
