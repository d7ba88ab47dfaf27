#pragma once

#include "approx/cosine.hpp"

/// Where the error of a minimax fit is at its level, and what else holds the optimum.
namespace shadefit {

/// Why a place belongs to the alternation.
enum class Touch {
  highest,   ///< weight * error is the level (0 where the form may not exceed its target)
  lowest,    ///< it is minus the level (0 where the form may not fall below its target)
  exact,     ///< the form is its target here by constraint
  at_most,   ///< the form is at its upper bound
  at_least,  ///< the form is at its lower bound
};

struct AlternationPoint {
  Touch touch;
  bool is_tangent;  ///< it is the slope that the constraint holds: the value is the bound whatever the
                    ///< parameters
  Cosine<double> at;
  double error;       ///< weight * error
  double multiplier;  ///< how much it holds the level up; those of `highest` and `lowest` sum to 1
};

}  // namespace shadefit
