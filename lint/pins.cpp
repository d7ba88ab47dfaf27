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
#include "lint/scan/literals.hpp"

namespace shadefit::lint {
namespace {

constexpr std::string_view mark = "shadefit:", word_of_ignoring = "ignore";

/// The line before a mark, without the start of the comment; null if no comment starts there.
std::string_view before_comment(std::string_view line) {
  line = line.substr(0, begin_of_run(line, line.size(), is_blank));
  for (const std::string_view begin : {"//", "#", "/*", "<!--"})
    if (line.ends_with(begin)) return line.substr(0, line.size() - begin.size());
  return {};
}

/// The word after a mark, without the end of a sentence or of the comment.
std::string_view name_behind(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
  const auto is_of_pin = [](char c) { return is_of_name(c) || c == '-' || c == '.'; };
  const std::string_view name = text.substr(0, end_of_run(text, 0, is_of_pin));
  return name.substr(0, name.find_last_not_of(".-") + 1);  // npos + 1 is 0
}

/// The last number of a line. Empty if the line has no number, if a 0 or a version follows the number, or if
/// the line has a hexadecimal number.
std::string_view last_number(std::string_view line) {
  if (line.find("0x") != std::string_view::npos || line.find("0X") != std::string_view::npos) return {};
  const std::vector<Literal> all = literals_of(line, CommentStyle::none);
  if (all.empty()) return {};
  const std::size_t end = all.back().offset + all.back().length;
  for (std::size_t i = end; i < line.size(); ++i)
    if (is_digit(line[i]) && (i == end || !is_of_name(line[i - 1]))) return {};
  return line.substr(all.back().offset, all.back().length);
}

/// What stands behind the word, without the end of the comment.
std::string reason_in(std::string_view text) {
  for (const std::string_view end : {"*/", "-->"}) text = text.substr(0, text.find(end));
  const std::size_t first = text.find_first_not_of(" \t:"), last = text.find_last_not_of(" \t\r");
  if (first == std::string_view::npos || first > last) return "no reason given";
  return std::string(text.substr(first, last - first + 1));
}

/// The constants that a name means, one for each source; or what is wrong with the name.
struct PinTargets {
  std::vector<ConstantPlace> found = {};
  std::string fault = {};
};

PinTargets targets_of(std::string_view name, const std::vector<KnownSet>& sets) {
  std::set<std::string> names, forms;
  PinTargets targets;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    const KnownSet& set = sets[i];
    for (std::size_t j = 0; j < set.constants.size(); ++j) {
      if (set.constants[j].is_of_form) continue;  // it has no name
      const std::string plain = set.id + "." + set.constants[j].name,
                        full =
                            set.form.empty() ? plain : set.id + "." + set.form + "." + set.constants[j].name;
      names.insert({plain, full});
      if (name != plain && name != full) continue;
      targets.found.push_back({i, j});
      forms.insert(full);
    }
  }
  if (targets.found.empty()) {
    const auto nearest = nearest_name(name, std::vector(names.begin(), names.end()));
    targets.fault = fmt::format("no published constant has the name '{}'{}", name,
                                nearest ? fmt::format("; did you mean '{}'?", *nearest) : "");
  } else if (forms.size() > 1) {
    targets.fault =
        fmt::format("several published forms have '{}'; write {}", name, fmt::join(forms, " or "));
  }
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

LintedSite judged_as(const Pin& pin, const ConstantPlace& target, const std::vector<KnownSet>& sets,
                     const EffectLimits& limits) {
  const KnownSet& set = sets[target.set];
  const KnownConstant& constant = set.constants[target.constant];
  const Digits found = digits_of(pin.number);
  const SiteNumber number = matched(found, set, target.constant);
  std::vector<double> constants = published_values(set);
  double& value = constants[target.constant];
  value = std::copysign(number_of(found), value);
  Site site;
  site.set = target.set;
  site.numbers = {number};
  KnownEffects effects;
  LintedSite judged = graded_site(set, site, {.form = set.formula, .constants = constants}, limits, effects);
  judged.is_pinned = true;
  judged.numbers = {{constant.name, constant.printed, std::string(pin.number), grade_of(set, number),
                     pin.number_offset, true}};
  if (number.variant) judged.replaced = set.variants[*number.variant].replaced;
  return judged;
}

LintedSite faulty(const Pin& pin, const std::string& fault) {
  LintedSite site;
  site.id = pin.name;
  site.grade = Grade::wrong;
  site.is_pinned = true;
  site.fault = fault;
  return site;
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

LintedSite judge_pin(const Pin& pin, const std::vector<KnownSet>& sets, const EffectLimits& limits) {
  const PinTargets targets = targets_of(pin.name, sets);
  if (!targets.fault.empty()) return faulty(pin, targets.fault);
  if (pin.number.empty())
    return faulty(pin, fmt::format("'{}' has no decimal number before it in its line", pin.name));
  const double found = number_of(digits_of(pin.number));
  std::optional<LintedSite> best;
  double best_distance = 0;
  for (const ConstantPlace& target : targets.found) {
    LintedSite one = judged_as(pin, target, sets, limits);
    const double distance = std::abs(std::abs(sets[target.set].constants[target.constant].value) - found);
    if (best && std::pair(one.grade, distance) >= std::pair(best->grade, best_distance)) continue;
    best = std::move(one);
    best_distance = distance;
  }
  return *best;
}

}  // namespace shadefit::lint
