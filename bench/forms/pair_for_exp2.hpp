#pragma once

#include <string>

#include "fit/steps/status.hpp"

/// The Fresnel pair, fitted for a polynomial instead of exp2.
namespace shadefit {

/// The pair of exp2((a c + b) c) with the least largest |form - (1-c)^5| over c in [0, 1] if exp2 is a
/// polynomial of approx/exp2_polynomial.hpp and everything else is exact. It compensates a part of the
/// polynomial's error: with degree 2 the published pair is off by 0.0050, this pair by 0.0037.
struct PairForExp2 {
  double a = 0, b = 0;  ///< an answer only if `status` is converged
  double level = 0;     ///< the largest error, sampled
  Status status = Status::not_converged;
  std::string why = {};
};

/// The pair for the polynomial of a degree from `least_exp2_degree` to `largest_exp2_degree`, for float.
/// Throws std::logic_error for another.
PairForExp2 fit_pair_for_exp2(int degree);

}  // namespace shadefit
