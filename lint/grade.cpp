#include "lint/grade.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "fit/support/decimal.hpp"

namespace shadefit::lint {
namespace {

bool is_visible(const LintedSite& site, const EffectLimits& limits) {
  const double change = site.effect.absolute.magnitude;
  if (std::isnan(change)) return true;
  if (limits.of_all) return change > *limits.of_all;
  return site.is_shown ? site.effect.srgb_codes > limits.codes : change > limits.change;
}

}  // namespace

std::string_view name(Grade grade) {
  constexpr std::array<std::string_view, 5> names{"right", "truncated", "outdated", "typo", "wrong"};
  return names[static_cast<std::size_t>(grade)];
}

Grade grade_of(const KnownSet& set, const SiteNumber& number) {
  if (number.variant) {
    const KnownVariant& variant = set.variants[*number.variant];
    if (variant.is_right) return Grade::right;
    if (!variant.replaced.empty()) return Grade::outdated;
    const bool is_short =
        is_shortened(digits_of(variant.printed), digits_of(set.constants[number.constant].printed));
    return is_short ? Grade::truncated : Grade::typo;
  }
  if (number.match < DigitMatch::rounded) return Grade::right;
  return number.match == DigitMatch::rounded ? Grade::truncated : Grade::typo;
}

Grade grade_of_other(const KnownConstant& constant, double found) {
  return is_shortened(digits_of(to_text(std::abs(found))), digits_of(constant.printed)) ? Grade::truncated
                                                                                        : Grade::typo;
}

std::vector<double> constants_at(const KnownSet& set, const Site& site, std::span<const Literal> literals) {
  std::vector<double> values = published_values(set);
  const bool has_other_units = is_in_other_units(site);
  for (const SiteNumber& number : site.numbers) {
    if (number.match < DigitMatch::rounded) continue;
    if (has_other_units && number.match == DigitMatch::shifted) continue;
    Digits digits = literals[number.literal].digits;
    const Digits published = digits_of(set.constants[number.constant].printed);
    if (has_other_units && !have_near_exponents(digits, published)) digits.exponent = published.exponent;
    double& value = values[number.constant];
    value = std::copysign(number_of(digits), value);
  }
  return values;
}

LintedSite graded_site(const KnownSet& set, const Site& site, const ExpressionMatch& found,
                       const EffectLimits& limits, KnownEffects& effects) {
  LintedSite graded;
  graded.id = set.id;
  graded.form = set.form;
  graded.source = set.source;
  graded.is_encoded = set.is_encoded;
  if (found.is_published) return graded;
  const bool has_other_units = is_in_other_units(site);
  for (const SiteNumber& number : site.numbers) {
    if (has_other_units && number.match == DigitMatch::shifted) continue;
    graded.grade = std::max(graded.grade, grade_of(set, number));
  }
  if (found.replaced)
    graded.grade = std::max(graded.grade,
                            grade_of_other(set.constants[*found.replaced], found.constants[*found.replaced]));
  if (!found.slip.empty()) graded.grade = Grade::typo;
  if (graded.grade == Grade::right) return graded;
  graded.is_shown = effects.shown.get(&set, [&] { return is_shown(set); });
  graded.effect = effects.effects.get({&set, to_text(found.form), found.constants},
                                      [&] { return effect_of(set, found.form, found.constants); });
  if (is_visible(graded, limits)) graded.grade = Grade::wrong;
  return graded;
}

}  // namespace shadefit::lint
