#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fit/formula/definition.hpp"
#include "fit/scalars/symbolic.hpp"

/// Reads closed forms, as people write them, into the symbolic scalar.
namespace shadefit {

/// The largest number of characters of a formula, and of operations inside one another; a sum of n terms
/// counts as n - 1. Functions on formulas are recursive, so the depth needs a limit.
inline constexpr std::size_t longest_formula = 4000;
inline constexpr std::size_t deepest_formula = 200;

class FormulaText;

/// What an expression of a program has where a formula has numbers, names and casts. Both move behind what
/// they read.
struct ProgramNotation {
  Symbolic (*atom)(FormulaText& text);                    ///< a number, or a name with what belongs to it
  Symbolic (*behind)(Symbolic value, FormulaText& text);  ///< a value with what stands behind it
};

/// The names that a formula may contain besides pi, ln2 and the functions.
struct FormulaNames {
  std::vector<std::string> variables;
  std::map<std::string, Definition, std::less<>> definitions = {};
  /// Whether any other name is a parameter. Two or more letters directly before a parenthesis are not a
  /// parameter but an unknown function.
  bool takes_parameters = false;
  bool takes_integrals = false;  ///< whether `integral(body, t, lower, upper)`, fit/truths/truths.hpp and
                                 ///< named_formulas.hpp are read
  std::vector<std::string> parameters = {};  ///< then no other name is a parameter; empty: any may be
  const ProgramNotation* program = nullptr;  ///< then all names are read by it
};

struct ReadFormula {
  Symbolic formula;
  std::vector<std::string> parameters;  ///< in the order in which they first appear
};

/// Reads a formula such as "(a+2)/(4 pi (2 - 2^(-a/2)))", in the notation that `to_text(Symbolic)` writes, or
/// a scalar expression of GLSL, HLSL or C:
///   formula    disjunction, or disjunction ? formula : formula
///   disjunction, conjunction, negation   by ||, && and ! of comparisons
///   comparison sum, or sum with < <= > >= == or != and another sum
///   sum        [-] quotient, then any number of `+ quotient` and `- quotient`
///   quotient   product, then `/ power` and `* power`, from the left
///   product    powers by `*` or side by side: "8 pi (a + 2)"
///   power      atom, or atom ^ exponent, or atom ** exponent; an exponent is an atom or a signed number;
///   after an operator a sign
///              may stand before it
///   atom       a number (2, .5, 1e-3, 2.4f), pi, ln2, a name, a call, or a formula in parentheses; a cast
///   such
///              as `(float)` may stand before it
/// `integral(t^2, t, 0, x)` is the integral of t^2 from 0 to x; t is a new name. At most two are inside one
/// another. A power with a whole exponent is computed by multiplications. Any other is a real power; its base
/// must not be negative. Calls are those of fit/formula/shader_calls.hpp and of the definitions.
///
/// A text that people read in two ways is refused: "1/2 pi", "a^b^c" and "2 3" need parentheses or a `*`;
/// "2f" is refused too. In "2u", u is a variable or a definition if there is one of that name, else the
/// suffix of an integer; a form, where it may be a parameter too, is refused. A `;` may stand at the end, and
/// `std::`, `np.`, `numpy.` or `math.` before a function. Vectors, swizzles, `%`, statements, and what
/// mathematicians write (ln, e^x, |x|) are refused by name.
///
/// Spaces, tabs and ends of lines separate. A name is a letter or underscore, then letters, digits and
/// underscores. A name directly before a parenthesis is a call if it is a function, else a factor. A formula
/// that is too long or too deep is refused. Throws std::invalid_argument with one line that names the
/// formula, the place (1 for its first letter) and what was expected there. The result evaluates in every
/// scalar by `evaluate`.
ReadFormula read_formula(std::string_view text, const FormulaNames& names);

/// The same without parameters and definitions.
Symbolic parse_formula(std::string_view text, std::span<const std::string_view> variables);

}  // namespace shadefit
