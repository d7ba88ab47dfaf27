#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "fit/errors/effect.hpp"
#include "lint/expression/compare.hpp"
#include "lint/known/known_set.hpp"
#include "lint/scan/sites.hpp"

/// How right the constants of a site are.
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
  /// Of a colour, in 8-bit sRGB codes: what moves it by more than half a code may change the code.
  double codes = 0.5;
  /// Of any other curve: an 8-bit picture shows a change of 1/256 if the curve is a factor of its light; a
  /// quarter of that is below any code.
  double change = 1e-3;
  std::optional<double> of_all = {};  ///< of every curve, instead of both
};

struct GradedSite {
  Grade grade = Grade::right;
  Effect effect = {};     ///< of what stands there in place of what was published
  bool is_shown = false;  ///< whether the curve is a colour
};

/// The grade of a single number, by its digits alone.
Grade grade_of(const KnownSet& set, const SiteNumber& number);

/// The grade of a number in the place of a constant that does not match it: `truncated` for 0.0023 in place
/// of 0.00232, else `typo`.
Grade grade_of_other(const KnownConstant& constant, double found);

/// Whether the decimal points of several numbers stand elsewhere: then they are in other units, such as 1000
/// kelvin, and right.
bool is_in_other_units(const Site& site);

/// The constants of a set as they stand at a site, with the signs of the published ones: the sign belongs to
/// the expression around. A number that only has more digits, or those of a float, is the published one.
std::vector<double> constants_at(const KnownSet& set, const Site& site, std::string_view text,
                                 const std::vector<Literal>& literals);

/// The grade of a form with constants that stand at a site.
GradedSite grade_of(const KnownSet& set, const Site& site, const ExpressionMatch& found,
                    const EffectLimits& limits);

}  // namespace shadefit::lint
