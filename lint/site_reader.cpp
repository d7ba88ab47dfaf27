#include "lint/site_reader.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "lint/expression/source_expression.hpp"
#include "lint/grade/grade.hpp"

namespace shadefit::lint {
namespace {

/// A wrong expression is believed only where numbers and operations tell enough: log2 of how seldom two of
/// some 100 slips of some 100 forms fit by chance is 13, and the median form has 6 operations, a bit for
/// each.
constexpr double bits_for_a_slip = 13 + 6;

std::vector<std::size_t> missing_constants(const KnownSet& set, const Site& site) {
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < set.constants.size(); ++i) {
    const bool is_there = std::any_of(site.numbers.begin(), site.numbers.end(),
                                      [&](const SiteNumber& number) { return number.constant == i; });
    if (!is_there) missing.push_back(i);
  }
  return missing;
}

}  // namespace

SiteReader::SiteReader(std::string_view text, CommentStyle style, const std::vector<Literal>& literals,
                       const KnownSet& set, const Site& site)
    : text_(text),
      style_(style),
      literals_(literals),
      set_(set),
      site_(site),
      constants_(constants_at(set, site, text, literals)),
      missing_(missing_constants(set, site)) {}

std::optional<ExpressionMatch> SiteReader::read() const {
  if (is_in_other_units(site_) || lacks_constants()) return std::nullopt;
  std::vector<double> numbers;
  for (const SiteNumber& number : site_.numbers) numbers.push_back(std::abs(constants_[number.constant]));
  const Literal &first = literals_[site_.numbers.front().literal],
                &last = literals_[site_.numbers.back().literal];
  std::optional<ExpressionMatch> slip, core;
  for (const Symbolic& one : expressions(first, last)) {
    auto match = match_expression(one, set_, constants_, numbers, missing_);
    if (!match) continue;
    if (match->is_core && !match->replaced) {
      if (!core) core = std::move(match);
      continue;
    }
    if (match->slip.empty()) return match;
    // A comment may tell its formula in halves.
    if (!slip && !first.is_in_comment && site_.numbers.size() > 1 &&
        site_.bits + count_operations(set_.formula).total() >= bits_for_a_slip)
      slip = std::move(match);
  }
  return slip ? slip : core;
}

Reading SiteReader::reading() const {
  const std::size_t count = site_.numbers.size();
  if (const auto match = read(); match && match->slip.empty() && !match->is_core)
    return {Reading::Part::form, count + (match->replaced ? 1 : 0)};
  const bool has_branch = set_.formula.kind() == Symbolic::Kind::choice &&
                          (reads_branch(set_.formula.part(2)) || reads_branch(set_.formula.part(3)));
  return {has_branch ? Reading::Part::branch : Reading::Part::nothing, count};
}

/// Whether more than one constant is missing that a program has to write: not 1 or pi/2. Then no expression
/// can be the form.
bool SiteReader::lacks_constants() const {
  return std::count_if(missing_.begin(), missing_.end(),
                       [&](std::size_t constant) { return !set_.constants[constant].is_common; }) > 1;
}

/// What is computed around the numbers: in one statement, then in several.
std::vector<Symbolic> SiteReader::expressions(const Literal& first, const Literal& last) const {
  const std::size_t begin = first.offset, end = last.offset + last.length;
  std::vector<Symbolic> found;
  for (const std::string_view one : expressions_around(text_, begin, end))
    if (auto expression = read_expression(one, style_)) found.push_back(std::move(*expression));
  for (Symbolic& value : values_around(text_, begin, end, style_)) found.push_back(std::move(value));
  return found;
}

/// Whether the text around the constants of one branch of the form computes it: pow((u + a)/b, p). Simpler
/// branches, such as u/s, are in many formulas.
bool SiteReader::reads_branch(const Symbolic& branch) const {
  constexpr std::size_t least_constants = 2;
  std::vector<const SiteNumber*> there;
  std::vector<double> numbers;
  const std::set<std::string> names = names_of(branch);
  for (const SiteNumber& number : site_.numbers) {
    if (names.count(set_.constants[number.constant].name) == 0) continue;
    there.push_back(&number);
    numbers.push_back(std::abs(constants_[number.constant]));
  }
  if (there.size() < least_constants) return false;
  KnownSet set = set_;
  set.formula = branch;
  const std::vector<Symbolic> all =
      expressions(literals_[there.front()->literal], literals_[there.back()->literal]);
  return std::any_of(all.begin(), all.end(), [&](const Symbolic& expression) {
    return is_form(expression, set, constants_, numbers);
  });
}

}  // namespace shadefit::lint
