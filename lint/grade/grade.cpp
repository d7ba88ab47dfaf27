#include "lint/grade/grade.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace shadefit {
namespace {

double value_of(const Digits& digits) {
  return mantissa_of(digits) * std::pow(10.0, digits.exponent);
}

Grade grade_of(const KnownSet& set, const SiteNumber& number) {
  if (number.variant) return set.variants[*number.variant].replaced.empty() ? Grade::typo : Grade::outdated;
  switch (number.match) {
    case DigitMatch::same:
    case DigitMatch::longer:
    case DigitMatch::float32:
      return Grade::right;
    case DigitMatch::rounded:
      return Grade::truncated;
    case DigitMatch::shifted:
    case DigitMatch::edited:
      return Grade::typo;
  }
  return Grade::right;
}

/// Whether the decimal point of several numbers stands elsewhere: then they are in other units, such as 1000
/// kelvin, and right.
bool is_in_other_units(const Site& site) {
  return std::count_if(site.numbers.begin(), site.numbers.end(),
                       [](const SiteNumber& number) { return number.match == DigitMatch::shifted; }) > 1;
}

}  // namespace

std::string_view name(Grade grade) {
  constexpr std::array<std::string_view, 5> names{"right", "truncated", "outdated", "typo", "wrong"};
  return names[static_cast<std::size_t>(grade)];
}

Grade with_effect(Grade grade, const Effect& effect, bool is_shown, const EffectLimits& limits) {
  const bool is_visible =
      is_shown ? effect.srgb_codes > limits.codes : effect.absolute.magnitude > limits.change;
  return is_visible || std::isnan(effect.absolute.magnitude) ? Grade::wrong : grade;
}

GradedSite grade_of(const KnownSet& set, const Site& site, std::string_view text,
                    const std::vector<Literal>& literals, const EffectLimits& limits) {
  GradedSite graded{.values = published_values(set)};
  const bool has_other_units = is_in_other_units(site);
  for (const SiteNumber& number : site.numbers) {
    if (has_other_units && number.match == DigitMatch::shifted) continue;
    graded.grade = std::max(graded.grade, grade_of(set, number));
    // A number that only has more digits, or those of a float, is the published one.
    if (number.match < DigitMatch::rounded) continue;
    const Literal& literal = literals[number.literal];
    const double found = value_of(digits_of(text.substr(literal.offset, literal.length)));
    double& value = graded.values[number.constant];
    value = std::copysign(found, value);  // the sign belongs to the expression around
  }
  if (graded.grade == Grade::right) return graded;
  graded.is_shown = is_shown(set);
  graded.effect = effect_of(set, graded.values);
  graded.grade = with_effect(graded.grade, graded.effect, graded.is_shown, limits);
  return graded;
}

}  // namespace shadefit
