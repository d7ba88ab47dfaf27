#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fit/errors/effect.hpp"
#include "lint/expression/compare.hpp"
#include "lint/scan/known_set.hpp"
#include "lint/scan/sites.hpp"

/// Grades the constants of a site.
namespace shadefit::lint {

/// From harmless to harmful.
enum class Grade {
  right,      ///< the published digits, or those of the nearest float
  truncated,  ///< fewer digits
  outdated,   ///< a value that its own source or standard has replaced
  typo,       ///< other digits or another operation, without a visible effect
  wrong,      ///< with a visible effect
};

std::string_view name(Grade grade);

/// The effects above which a site is `wrong`.
struct EffectLimits {
  /// For a colour, in 8-bit sRGB codes: a change of more than half a code may change the code.
  double codes = 0.5;
  /// For any other curve: an 8-bit picture shows a change of 1/256 if the curve is a factor of its light; a
  /// quarter of that is never visible.
  double change = 1e-3;
  std::optional<double> of_all = {};  ///< for every curve, instead of both
};

/// A place in a text. Lines and columns count from 1, columns in code points.
struct TextPlace {
  long line = 0, column = 0;
  auto operator<=>(const TextPlace&) const = default;
};

/// A number as it stands in a text.
struct NumberCopy {
  std::size_t offset = 0;  ///< in bytes
  std::string text;
};

/// A number of a site and the published one.
struct LintedNumber {
  std::string constant, published;  ///< name and digits
  std::string text;                 ///< as found
  Grade grade = Grade::right;
  std::size_t offset = 0;  ///< in the text, in bytes
  /// Whether the published number belongs there: no other number near it may be the constant, no other source
  /// may be meant, and the numbers are in the published units.
  bool is_certain = false;
  std::vector<NumberCopy> copies = {};  ///< the other components of a vector of this number
};

/// Constants of a set in a text, or a number that a mark pins to a constant (lint/pins.hpp).
struct LintedSite {
  std::string file;
  TextPlace begin, end;  ///< of its first number, and after its last
  std::string id, form;  ///< of the set
  std::string source;
  std::vector<LintedNumber> numbers;  ///< by their places
  Grade grade = Grade::right;
  Effect effect = {};
  bool is_shown = false;
  bool is_encoded = false;                  ///< see `KnownSet`
  std::string slip = {};                    ///< of the expression: see ExpressionMatch
  std::string replaced = {};                ///< why the source replaced a value that is found here
  bool is_in_comment = false;               ///< whether all numbers are
  bool is_in_table = false;                 ///< the set is a small part of a table of numbers
  std::optional<std::string> ignored = {};  ///< the reason of a mark "shadefit: ignore REASON"
  bool is_pinned = false;
  std::string fault = {};  ///< why a mark pins nothing; then there are no numbers
};

/// The grade of a single number, by its digits alone.
Grade grade_of(const KnownSet& set, const SiteNumber& number);

/// The grade of a number that replaces a constant and does not match it: `truncated` for 0.0023 instead of
/// 0.00232, otherwise `typo`.
Grade grade_of_other(const KnownConstant& constant, double found);

/// The constants of a set as found at a site, with the signs of the published ones: the expression has the
/// sign. A number that only has more digits, or those of a float, counts as the published one. In other units
/// the decimal point of a number says nothing.
std::vector<double> constants_at(const KnownSet& set, const Site& site, std::span<const Literal> literals);

/// A form with the constants found at a site, graded, still without its numbers.
LintedSite graded_site(const KnownSet& set, const Site& site, const ExpressionMatch& found,
                       const EffectLimits& limits, KnownEffects& effects);

}  // namespace shadefit::lint
