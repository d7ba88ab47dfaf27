#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "fit/scalars/symbolic.hpp"

/// Reads closed forms, as people write them, into the symbolic scalar.
namespace shadefit {

/// The largest number of characters of a formula, and of operations inside one another; a sum of n terms
/// counts as n - 1. Functions on formulas are recursive, so the depth needs a limit.
inline constexpr std::size_t longest_formula = 1000;
inline constexpr std::size_t deepest_formula = 200;

/// Reads a formula such as "(a+2)/(4 pi (2 - 2^(-a/2)))" in the notation that `to_text(Symbolic)` writes:
///   sum       [-] quotient, then any number of `+ quotient` and `- quotient`
///   quotient  product, or product / power
///   product   powers by `*` or side by side: "8 pi (a + 2)"
///   power     atom, or atom ^ exponent; an exponent is an atom or a signed number
///   atom      a number (2, 0.5, 1e-3), pi, ln2, a variable, a function of the vocabulary with its arguments
///             ("exp2(-a)", "max(a, 0)"), a sum in parentheses, or a choice "(a < b ? yes : no)"
/// A power with a whole exponent is computed by multiplications. Any other is a real power; its base must not
/// be negative.
///
/// A text that people read in two ways is refused: "1/2 pi", "a/b/c", "a^b^c", "2 3" and "a + -b" need
/// parentheses or a `*`.
///
/// `variables` are the names that a formula may contain besides pi and ln2. A name is a letter or underscore,
/// then letters, digits and underscores. A formula that is too long or too deep is refused. Throws
/// std::invalid_argument with one line that names the formula, the place (1 for its first letter) and what
/// was expected there. The result evaluates in every scalar by `evaluate`.
Symbolic parse_formula(std::string_view text, std::span<const std::string_view> variables);

}  // namespace shadefit
