#pragma once

#include "approx/cosine.hpp"

/// The places that determine a minimax fit: the error is at its level there, or a constraint is active.
namespace shadefit {

/// Why a place belongs to the alternation.
enum class Touch {
  highest,   ///< weight * error is the level (0 where the form may not exceed its target)
  lowest,    ///< it is minus the level (0 where the form may not fall below its target)
  exact,     ///< the form is its target here by constraint
  at_most,   ///< the form is at its upper bound
  at_least,  ///< the form is at its lower bound
  falls,     ///< the form, which never rises, has the slope 0
  rises,     ///< the form, which never falls, has the slope 0
};

struct AlternationPoint {
  Touch touch;
  bool is_tangent;  ///< the constraint is on the slope: the value is at the bound for all parameters
  Cosine<double> at;
  double error;       ///< weight * error
  double multiplier;  ///< Lagrange's; those of `highest` and `lowest` sum to 1
};

}  // namespace shadefit
