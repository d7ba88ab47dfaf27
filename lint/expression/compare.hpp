#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "fit/scalars/symbolic.hpp"
#include "lint/scan/known_set.hpp"

/// Whether the expression of a site is the form of its set.
namespace shadefit::lint {

/// What an expression in a source text is, compared with the form of a set.
struct ExpressionMatch {
  Symbolic form;                  ///< that of the set, or that with the slip
  std::vector<double> constants;  ///< in it
  /// A slip by which it differs from the form: "1 + k c for 1 - k c"; empty: it is the form.
  std::string slip = {};
  /// Whether it computes the published curve with other numbers: 6.07995 + (90 - z).
  bool is_published = false;
  /// The constant of `missing` that another number replaces.
  std::optional<std::size_t> replaced = {};
};

/// Looks in the expression for a part that holds as many of these numbers as the whole does, and has the
/// values of the form. The form may be unchanged, may have a
/// constant of `missing` replaced by a number of the expression, or may have one slip (see mutants_of). The
/// names of the expression may be the variables of the form in any order. Empty if no part matches.
std::optional<ExpressionMatch> match_expression(const Symbolic& expression, const KnownSet& set,
                                                const std::vector<double>& constants,
                                                const std::vector<double>& numbers,
                                                const std::vector<std::size_t>& missing);

/// Whether such a part has the values of the unchanged form.
bool is_form(const Symbolic& expression, const KnownSet& set, const std::vector<double>& constants,
             const std::vector<double>& numbers);

/// A formula with one slip: a small mistake in copying.
struct Mutant {
  Symbolic formula;
  std::string words;  ///< "1 + k c for 1 - k c"
};

/// The formulas that differ from this one in one operation: another sign, a product for a sum, a function of
/// the same family (exp for exp2), a lost term or factor, swapped operands, a lost or moved pair of
/// parentheses, or an operand moved into or out of a function's argument. A missing constant factor, such as
/// 1/pi, is not a slip: it may be elsewhere.
std::vector<Mutant> mutants_of(const Symbolic& formula);

/// The names of the variables and constants of a formula.
std::set<std::string> names_of(const Symbolic& formula);

}  // namespace shadefit::lint
