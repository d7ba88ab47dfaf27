#pragma once

#include <vector>

#include "fit/scalars/symbolic.hpp"

namespace shadefit {

/// A part of a formula. At its zeros the formula is not smooth.
struct Hinge {
  Symbolic part;
  bool is_root;          ///< a zero is singular even if the sign does not change
  bool is_pole;          ///< the formula is not finite there
  bool is_jump = false;  ///< the formula may have another value on each side
};

/// The hinges of a formula, inner ones first: the differences that `min`, `max` and choices compare, the
/// arguments of roots, powers and logarithms, denominators, and what `abs`, `sign`, `floor`, `asin` and
/// `acos` are not smooth at.
std::vector<Hinge> hinges_of(const Symbolic& formula);

}  // namespace shadefit
