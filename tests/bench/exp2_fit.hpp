#pragma once

#include <string>
#include <vector>

#include "fit/least_squares/status.hpp"

/// The polynomials of approx/exp2_polynomial.hpp, fitted.
namespace shadefit::testing {

/// p(r) = 1 + c1 r + .. + cn r^n with the least largest |p(r)/2^r - 1| on [-1/2, 1/2].
struct Exp2Fit {
  int degree = 0;
  std::vector<long double> coefficients = {};  ///< c1 .. cn; an answer only if `status` is converged
  double level = 0;                            ///< the largest relative error, sampled
  int contacts = 0;                            ///< places where |error| is the level, with alternating signs
  Status status = Status::not_converged;
  std::string why = {};
};

/// The fit of a degree from `least_exp2_degree` to `largest_exp2_degree`. Throws std::logic_error for
/// another.
Exp2Fit fit_exp2(int degree);

}  // namespace shadefit::testing
