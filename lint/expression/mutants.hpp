#pragma once

#include <string>
#include <vector>

#include "fit/scalars/symbolic.hpp"

/// Formulas with one slip of the pen.
namespace shadefit::lint {

struct Mutant {
  Symbolic formula;
  std::string words;  ///< "1 + k c for 1 - k c"
};

/// The formulas that differ from this one at one operation: another sign, a product for a sum, a function of
/// the same family (exp for exp2), a lost term or factor, swapped operands, a lost or moved pair of
/// parentheses, or an operand moved into or out of a function's argument. A factor that is a number, such as
/// 1/pi, is no slip where it is missing: it may stand elsewhere.
std::vector<Mutant> mutants_of(const Symbolic& formula);

}  // namespace shadefit::lint
