#include "lint/pins/judge_pin.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "fit/support/nearest.hpp"
#include "lint/scan/digit_match.hpp"

namespace shadefit::lint {
namespace {

/// The parts of a name: STUDY.CONSTANT or STUDY.FORM.CONSTANT.
struct PinName {
  std::string study, form, constant;
};

std::optional<PinName> split(std::string_view name) {
  const std::size_t first = name.find('.'), last = name.rfind('.');
  if (first == std::string_view::npos || first == 0) return std::nullopt;
  PinName parts{std::string(name.substr(0, first)), "", std::string(name.substr(last + 1))};
  if (last > first) parts.form = name.substr(first + 1, last - first - 1);
  return parts;
}

/// "; did you mean 'x'?", or all names if they are few.
std::string advice(const std::string& misspelled, const std::set<std::string>& known) {
  const std::vector<std::string> names(known.begin(), known.end());
  constexpr std::size_t few = 8;
  if (const auto nearest = nearest_name(misspelled, names))
    return fmt::format("; did you mean '{}'?", *nearest);
  return names.size() <= few ? fmt::format("; it has {}", fmt::join(names, ", ")) : "";
}

/// A constant of a set.
struct PinTarget {
  std::size_t set, constant;
};

/// The constants that a name means, one for each source; or what is wrong with the name.
struct PinTargets {
  std::vector<PinTarget> found = {};
  std::string fault = {};
};

PinTargets targets_of(std::string_view name, const std::vector<KnownSet>& sets) {
  const auto parts = split(name);
  if (!parts) return {.fault = fmt::format("'{}' must be STUDY.CONSTANT or STUDY.FORM.CONSTANT", name)};
  std::set<std::string> studies, forms, constants, forms_found;
  PinTargets targets;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    studies.insert(sets[i].id);
    if (sets[i].id != parts->study || !sets[i].times.empty()) continue;
    forms.insert(sets[i].form);
    if (!parts->form.empty() && sets[i].form != parts->form) continue;
    for (std::size_t j = 0; j < sets[i].constants.size(); ++j) {
      if (sets[i].constants[j].is_of_form) continue;  // it has no name
      constants.insert(sets[i].constants[j].name);
      if (sets[i].constants[j].name != parts->constant) continue;
      targets.found.push_back({i, j});
      forms_found.insert(sets[i].form);
    }
  }
  if (forms.empty())
    targets.fault =
        fmt::format("no study '{}' has published constants{}", parts->study, advice(parts->study, studies));
  else if (constants.empty())
    targets.fault = fmt::format("'{}' has no published form '{}'{}", parts->study, parts->form,
                                advice(parts->form, forms));
  else if (targets.found.empty())
    targets.fault = fmt::format("'{}' has no published constant '{}'{}", parts->study, parts->constant,
                                advice(parts->constant, constants));
  else if (forms_found.size() > 1)
    targets.fault = fmt::format("'{}' has several published forms; write {}.{}.{}", parts->study,
                                parts->study, fmt::join(forms_found, "|"), parts->constant);
  return targets;
}

/// Whether a number has the digits of the nearest float of a short published one: 0.774999976 for 0.775.
/// `match_digits` covers longer ones.
bool has_float_of(const Digits& found, double published) {
  constexpr std::size_t digits_of_a_float = 7;
  return found.text.size() >= digits_of_a_float &&
         static_cast<float>(number_of(found)) == static_cast<float>(std::abs(published));
}

SiteNumber matched(const Digits& found, const KnownSet& set, std::size_t constant) {
  auto match = match_digits(found, digits_of(set.constants[constant].printed));
  if (has_float_of(found, set.constants[constant].value)) match = DigitMatch::float32;
  SiteNumber number{0, constant, match.value_or(DigitMatch::edited), {}};
  if (match && *match <= DigitMatch::float32) return number;
  for (std::size_t i = 0; i < set.variants.size(); ++i)
    if (set.variants[i].constant == constant && digits_of(set.variants[i].printed) == found)
      number.variant = i;
  return number;
}

JudgedPin judged_as(const Pin& pin, const PinTarget& target, const std::vector<KnownSet>& sets,
                    const EffectLimits& limits) {
  const KnownSet& set = sets[target.set];
  const Digits found = digits_of(pin.number);
  const SiteNumber number = matched(found, set, target.constant);
  JudgedPin judged{.pin = pin, .set = target.set, .constant = target.constant};
  judged.digits = grade_of(set, number);
  if (number.variant) judged.replaced = set.variants[*number.variant].replaced;
  std::vector<double> constants = published_values(set);
  double& value = constants[target.constant];
  value = std::copysign(number_of(found), value);
  Site site;
  site.set = target.set;
  site.numbers = {number};
  KnownEffects effects;
  judged.graded = grade_of(set, site, {.form = set.formula, .constants = constants}, limits, effects);
  return judged;
}

}  // namespace

JudgedPin judge_pin(const Pin& pin, const std::vector<KnownSet>& sets, const EffectLimits& limits) {
  const PinTargets targets = targets_of(pin.name, sets);
  if (!targets.fault.empty()) return {.pin = pin, .fault = targets.fault};
  if (pin.number.empty())
    return {.pin = pin, .fault = fmt::format("'{}' has no decimal number before it in its line", pin.name)};
  const double found = number_of(digits_of(pin.number));
  std::optional<JudgedPin> best;
  const auto distance = [&](const JudgedPin& one) {
    return std::abs(std::abs(sets[one.set].constants[one.constant].value) - found);
  };
  for (const PinTarget& target : targets.found) {
    JudgedPin one = judged_as(pin, target, sets, limits);
    if (!best || std::pair(one.graded.grade, distance(one)) < std::pair(best->graded.grade, distance(*best)))
      best = std::move(one);
  }
  return *best;
}

}  // namespace shadefit::lint
