#pragma once

#include <optional>
#include <span>
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

struct GradedSite {
  Grade grade = Grade::right;
  Effect effect = {};     ///< of the numbers found instead of the published ones
  bool is_shown = false;  ///< whether the curve is a colour
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

/// The grade of a form with the constants found at a site.
GradedSite grade_of(const KnownSet& set, const Site& site, const ExpressionMatch& found,
                    const EffectLimits& limits, KnownEffects& effects);

}  // namespace shadefit::lint
