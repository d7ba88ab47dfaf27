#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fit/errors/effect.hpp"
#include "lint/known/known_set.hpp"
#include "lint/scan/sites.hpp"

/// How right the constants of a site are.
namespace shadefit {

/// From harmless to harmful.
enum class Grade {
  right,      ///< the published digits, or those of the nearest float
  truncated,  ///< fewer digits
  outdated,   ///< a value that its own source or standard has replaced
  typo,       ///< other digits, without a visible effect
  wrong,      ///< with a visible effect
};

std::string_view name(Grade grade);

/// What moves a curve that is no colour by more than this is `wrong`: a pixel of 8 bits shows it if the curve
/// is a factor of its light.
inline constexpr double visible_change = 1e-3;

/// What moves a colour by more than this many 8-bit sRGB codes is `wrong`: it may change a code.
inline constexpr double visible_codes = 0.5;

/// The limits of effect above which a site is `wrong`.
struct EffectLimits {
  double codes = visible_codes;    ///< of 8-bit sRGB, where the curve is a colour
  double change = visible_change;  ///< of other curves
};

struct GradedSite {
  Grade grade = Grade::right;
  std::vector<double> values;  ///< the constants of the set as they stand there
  Effect effect = {};          ///< of these in place of the published ones
  bool is_shown = false;       ///< whether the curve is a colour
};

GradedSite grade_of(const KnownSet& set, const Site& site, std::string_view text,
                    const std::vector<Literal>& literals, const EffectLimits& limits = {});

/// The grade of such an effect beside what the digits alone say.
Grade with_effect(Grade grade, const Effect& effect, bool is_shown, const EffectLimits& limits);

}  // namespace shadefit
