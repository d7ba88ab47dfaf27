#include "lint/pins.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "fit/support/nearest.hpp"
#include "lint/scan/characters.hpp"
#include "lint/scan/digit_match.hpp"
#include "lint/scan/notation.hpp"

namespace shadefit::lint {
namespace {

constexpr std::string_view mark = "shadefit:", word_of_ignoring = "ignore";

bool is_of_pin_name(char c) {
  return is_of_name(c) || c == '-' || c == '.';
}

/// The line before a mark, without the start of the comment; null if no comment starts there. Comments that
/// document begin with more: "//!<", "/**".
std::string_view before_comment(std::string_view line) {
  line = line.substr(0, begin_of_run(line, line.size(), is_blank));
  for (const std::string_view begin :
       {"//!<", "///<", "/**<", "/*!<", "//!", "/**", "/*!", "//", "#", "/*", "<!--"}) {
    if (!line.ends_with(begin)) continue;
    line.remove_suffix(begin.size());
    while (line.ends_with('/')) line.remove_suffix(1);  // "///"
    return line;
  }
  return {};
}

/// The word after a mark, without the end of a sentence or of the comment.
std::string_view name_behind(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
  const std::string_view name = text.substr(0, end_of_run(text, 0, is_of_pin_name));
  return name.substr(0, name.find_last_not_of(".-") + 1);  // npos + 1 is 0
}

/// Whether a member begins there: `v.x`, or `v.0` of a tuple, which is not a number.
bool begins_member(std::string_view line, std::size_t at) {
  return line[at] == '.' && at > 0 &&
         (is_of_name(line[at - 1]) || line[at - 1] == ')' || line[at - 1] == ']');
}

/// The number that a text begins with, unless more of a version or of a range follows: 1.2.3, 0..5.
std::string_view whole_number(std::string_view text) {
  const auto number = notation_at(text);
  if (!number) return {};
  const std::string_view rest = text.substr(number->length);
  const bool is_continued = rest.size() > 1 && rest[0] == '.' && (is_digit(rest[1]) || rest[1] == '.');
  return is_continued ? std::string_view{} : text.substr(0, number->length);
}

/// The end of a word, or of a number that is not decimal: 0x1.8p+1 is one number.
std::size_t end_of_other_number(std::string_view line, std::size_t at) {
  const bool is_hexadecimal = line[at] == '0' && at + 1 < line.size() && (line[at + 1] | 0x20) == 'x';
  const auto is_part = [&](std::size_t i) {
    const bool is_sign = line[i] == '+' || line[i] == '-';
    if (is_hexadecimal && is_sign) return (line[i - 1] | 0x20) == 'p';
    if (is_hexadecimal && line[i] == '\'') return true;  // separates digits
    return is_of_name(line[i]) || line[i] == '.';
  };
  ++at;
  while (at < line.size() && is_part(at)) ++at;
  return at;
}

/// The last number of a line; empty if there is none or if it is not decimal.
std::string_view last_number(std::string_view line) {
  std::string_view last;
  for (std::size_t i = 0; i < line.size();) {
    const std::string_view rest = line.substr(i);
    const bool is_member = begins_member(line, i);
    if (!is_member && (is_digit(rest[0]) || (rest[0] == '.' && rest.size() > 1 && is_digit(rest[1])))) {
      last = whole_number(rest);
      i = last.empty() ? end_of_other_number(line, i) : i + last.size();
    } else {
      i = is_member || is_of_name(rest[0]) ? end_of_run(line, i + 1, is_of_name) : i + 1;
    }
  }
  return last;
}

/// What stands behind the word, without the end of the comment.
std::string reason_in(std::string_view text) {
  for (const std::string_view end : {"*/", "-->"}) text = text.substr(0, text.find(end));
  const std::size_t first = text.find_first_not_of(" \t:"), last = text.find_last_not_of(" \t\r");
  if (first == std::string_view::npos || first > last) return "no reason given";
  return std::string(text.substr(first, last - first + 1));
}

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

/// The constants that a name means, one for each source; or what is wrong with the name.
struct PinTargets {
  std::vector<ConstantPlace> found = {};
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

SiteNumber matched(const Digits& found, const KnownSet& set, std::size_t constant) {
  const Digits published = digits_of(set.constants[constant].printed);
  auto match = match_digits(found, published);
  // 0.774999976 for 0.775: `match_digits` covers longer ones.
  if (is_same_float(found, published)) match = DigitMatch::float32;
  SiteNumber number{0, constant, match.value_or(DigitMatch::edited), {}};
  if (match && *match <= DigitMatch::float32) return number;
  for (std::size_t i = 0; i < set.variants.size(); ++i)
    if (set.variants[i].constant == constant && digits_of(set.variants[i].printed) == found)
      number.variant = i;
  return number;
}

JudgedPin judged_as(const Pin& pin, const ConstantPlace& target, const std::vector<KnownSet>& sets,
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

std::optional<std::string> ignore_reason(std::string_view line) {
  for (std::size_t at = line.find(mark); at != std::string_view::npos; at = line.find(mark, at + 1)) {
    const std::string_view rest = line.substr(at + mark.size()), word = name_behind(rest);
    if (word != word_of_ignoring || before_comment(line.substr(0, at)).data() == nullptr) continue;
    return reason_in(rest.substr(static_cast<std::size_t>(word.data() - rest.data()) + word.size()));
  }
  return std::nullopt;
}

std::vector<Pin> pins_of(std::string_view text) {
  std::vector<Pin> pins;
  std::size_t free = 0;  // after the last mark
  for (std::size_t at = text.find(mark); at != std::string_view::npos; at = text.find(mark, at + 1)) {
    const std::size_t line = std::max(free, line_begin(text, at));
    const std::string_view before = before_comment(text.substr(line, at - line));
    const std::string_view name = name_behind(text.substr(at + mark.size()));
    if (before.data() == nullptr || name.empty() || name == word_of_ignoring) continue;
    const std::string_view number = last_number(before);
    const auto offset_of = [&](std::string_view part) {
      return static_cast<std::size_t>(part.data() - text.data());
    };
    pins.push_back({offset_of(name), name, number.empty() ? 0 : offset_of(number), number});
    free = offset_of(name) + name.size();
  }
  return pins;
}

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
  for (const ConstantPlace& target : targets.found) {
    JudgedPin one = judged_as(pin, target, sets, limits);
    if (!best || std::pair(one.graded.grade, distance(one)) < std::pair(best->graded.grade, distance(*best)))
      best = std::move(one);
  }
  return *best;
}

}  // namespace shadefit::lint
