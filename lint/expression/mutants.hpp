#pragma once

#include <string>
#include <vector>

#include "fit/scalars/symbolic.hpp"

/// Formulas with one slip: a small mistake in copying.
namespace shadefit::lint {

struct Mutant {
  Symbolic formula;
  std::string words;  ///< "1 + k c for 1 - k c"
};

/// The formulas that differ from this one in one operation: another sign, a product for a sum, a function of
/// the same family (exp for exp2), a lost term or factor, swapped operands, a lost or moved pair of
/// parentheses, or an operand moved into or out of a function's argument. A missing constant factor, such as
/// 1/pi, is not a slip: it may be elsewhere.
std::vector<Mutant> mutants_of(const Symbolic& formula);

}  // namespace shadefit::lint
