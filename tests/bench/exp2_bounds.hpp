#pragma once

#include <string_view>
#include <vector>

#include "approx/exp2_polynomial.hpp"

/// Proven error bounds of the polynomials for exp2.
namespace shadefit::testing {

/// A polynomial and the bounds of its error.
struct Exp2Bounds {
  std::string_view format;  ///< "float" or "double"
  const Exp2Coefficients* polynomial;
  /// The largest |p(r)/2^r - 1| on [-1/2, 1/2] lies in [lower, upper]: for the printed digits or for their
  /// rounded values, whichever is worse.
  double lower = 0, upper = 0;
  /// A bound of the rounding error of evaluating p in that format, relative to p.
  double rounding = 0;
};

/// The bounds of all polynomials by format and degree, proven on each call.
std::vector<Exp2Bounds> exp2_bounds();

}  // namespace shadefit::testing
