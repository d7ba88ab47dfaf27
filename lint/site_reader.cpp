#include "lint/site_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "lint/expression/comment_text.hpp"
#include "lint/expression/source_expression.hpp"
#include "lint/grade/grade.hpp"
#include "lint/scan/digit_match.hpp"
#include "lint/scan/notation.hpp"

namespace shadefit::lint {
namespace {

/// A wrong expression counts only if numbers and operations are evidence enough. Two of some 100 slips of
/// some 100 forms fit by chance in one of 2^13 cases, and the median form has 6 operations, one bit for each.
constexpr double bits_for_a_slip = 13 + 6;

/// The indices of the two branches among the parts of a choice.
constexpr std::array<std::size_t, 2> branches{2, 3};

std::vector<std::size_t> missing_constants(const KnownSet& set, const Site& site) {
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < set.constants.size(); ++i) {
    const bool is_there = std::any_of(site.numbers.begin(), site.numbers.end(),
                                      [&](const SiteNumber& number) { return number.constant == i; });
    if (!is_there) missing.push_back(i);
  }
  return missing;
}

std::vector<Symbolic> expressions_in(std::string_view text, std::size_t begin, std::size_t end,
                                     CommentStyle style, ReadingMemory& memory) {
  const auto read = [&](std::string_view one, CommentStyle as) { return memory.read(one, as); };
  std::vector<Symbolic> found;
  for (const std::string_view one : expressions_around(text, begin, end))
    if (auto expression = read(one, style)) found.push_back(std::move(*expression));
  for (Symbolic& value : values_around(text, begin, end, style, read)) found.push_back(std::move(value));
  return found;
}

/// A part of a text and its numbers.
struct PartOfText {
  std::string text;
  std::vector<Literal> literals;
};

/// The text around the literals from `first` to `last`, with another number at some of them.
PartOfText part_with(std::string_view text, const std::vector<Literal>& literals, std::size_t first,
                     std::size_t last, std::span<const std::size_t> changed, std::string_view number) {
  constexpr std::size_t most_bytes_around = 2000;  // no expression is read farther away
  PartOfText part;
  std::size_t done = literals[first].offset - std::min(literals[first].offset, most_bytes_around);
  for (std::size_t i = first; i <= last; ++i) {
    Literal literal = literals[i];
    part.text += text.substr(done, literal.offset - done);
    done = literal.offset + literal.length;
    std::string digits(text.substr(literal.offset, literal.length));
    if (std::find(changed.begin(), changed.end(), i) != changed.end()) digits = rewritten(digits, number);
    literal.offset = part.text.size();
    literal.length = digits.size();
    literal.digits = digits_of(digits);
    part.literals.push_back(literal);
    part.text += digits;
  }
  part.text += text.substr(done, most_bytes_around);
  return part;
}

}  // namespace

SiteReader::SiteReader(std::string_view text, CommentStyle style, const std::vector<Literal>& literals,
                       const KnownSet& set, const Site& site, ReadingMemory& memory)
    : text_(text),
      style_(style),
      literals_(literals),
      set_(set),
      site_(site),
      memory_(memory),
      constants_(constants_at(set, site, literals)),
      missing_(missing_constants(set, site)) {}

std::optional<ExpressionMatch> SiteReader::read() const {
  if (is_in_other_units(site_) || lacks_constants()) return std::nullopt;
  std::vector<double> numbers;
  for (const SiteNumber& number : site_.numbers) numbers.push_back(std::abs(constants_[number.constant]));
  const Literal &first = literals_[site_.numbers.front().literal],
                &last = literals_[site_.numbers.back().literal];
  std::optional<ExpressionMatch> slip, core;
  for (const Symbolic& one : expressions(first, last)) {
    auto match = memory_.match(one, set_, constants_, numbers, missing_);
    if (!match) continue;
    if (match->is_core && !match->replaced) {
      if (!core) core = std::move(match);
      continue;
    }
    if (match->slip.empty()) return match;
    if (!slip && believes_slips()) slip = std::move(match);
  }
  if (slip) return slip;
  return core ? core : slip_of_branch();
}

bool SiteReader::believes_slips() const {
  return site_.numbers.size() > 1 && site_.bits + count_operations(set_.formula).total() >= bits_for_a_slip;
}

Reading SiteReader::reading() const {
  const std::size_t count = site_.numbers.size();
  if (const auto match = read(); match && match->slip.empty() && !match->is_core)
    return {Reading::Part::form, count + (match->replaced ? 1 : 0)};
  const bool has_branch =
      std::any_of(branches.begin(), branches.end(), [&](std::size_t part) { return reads_branch(part); });
  return {has_branch ? Reading::Part::branch : Reading::Part::nothing, count};
}

FoundLiterals SiteReader::literals_of(std::size_t constant, double value) const {
  const std::vector<std::size_t> near = candidates(constant, value);
  for (const std::size_t& one : near)
    if (is_form_with(constant, {&one, 1})) return {{one}, true};
  std::vector<std::size_t> all = near;
  std::sort(all.begin(), all.end());
  for (auto begin = all.begin(), end = begin; begin != all.end(); begin = end) {
    for (end = begin + 1; end != all.end() && *end == *(end - 1) + 1;) ++end;
    if (end - begin > 1 && is_form_with(constant, {begin, end})) return {{begin, end}, true};
  }
  return near.empty() ? FoundLiterals{} : FoundLiterals{{near.front()}, false};
}

/// The literals with this value that are no other constant, the nearest ones first.
std::vector<std::size_t> SiteReader::candidates(std::size_t constant, double value) const {
  constexpr std::size_t near = 8;
  const std::size_t first = site_.numbers.front().literal, last = site_.numbers.back().literal;
  const auto distance = [&](std::size_t i) {  // in bytes
    return i < first ? literals_[first].offset - literals_[i].offset
                     : literals_[i].offset - literals_[std::min(i, last)].offset;
  };
  std::vector<std::size_t> found;
  for (std::size_t i = first - std::min(first, near); i < std::min(literals_.size(), last + near); ++i) {
    const bool is_taken = std::any_of(
        site_.numbers.begin(), site_.numbers.end(),
        [&](const SiteNumber& number) { return number.literal == i && number.constant != constant; });
    if (!is_taken && number_of(literals_[i].digits) == value) found.push_back(i);
  }
  std::stable_sort(found.begin(), found.end(),
                   [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
  return found;
}

/// Whether the text is the form if the published number stands at these literals, which rise.
bool SiteReader::is_form_with(std::size_t constant, std::span<const std::size_t> at) const {
  Site site{site_.set, {}, site_.bits};
  for (const SiteNumber& number : site_.numbers)
    if (number.constant != constant) site.numbers.push_back(number);
  site.numbers.push_back({at.back(), constant});
  std::sort(site.numbers.begin(), site.numbers.end(),
            [](const SiteNumber& a, const SiteNumber& b) { return a.literal < b.literal; });
  const std::size_t first = std::min(at.front(), site.numbers.front().literal);
  const PartOfText part =
      part_with(text_, literals_, first, site.numbers.back().literal, at, set_.constants[constant].printed);
  for (SiteNumber& number : site.numbers) number.literal -= first;
  const auto match = SiteReader(part.text, style_, part.literals, set_, site, memory_).read();
  return match && match->slip.empty() && !match->replaced &&
         match->constants[constant] == set_.constants[constant].value;
}

/// Whether more than one constant is missing that a program must have, unlike 1 or pi/2. Then no expression
/// can be the form.
bool SiteReader::lacks_constants() const {
  return std::count_if(missing_.begin(), missing_.end(),
                       [&](std::size_t constant) { return !set_.constants[constant].is_common; }) > 1;
}

/// The values that are computed around the numbers: first in one statement, then in several.
std::vector<Symbolic> SiteReader::expressions(const Literal& first, const Literal& last) const {
  const std::size_t begin = first.offset, end = last.offset + last.length;
  if (!first.is_in_comment) return expressions_in(text_, begin, end, style_, memory_);
  constexpr std::size_t most_bytes_around = 700;
  const std::size_t start = begin - std::min(begin, most_bytes_around);
  const std::string program = comment_as_program(text_.substr(start, end - start + most_bytes_around));
  return expressions_in(program, begin - start, end - start, CommentStyle::none, memory_);
}

/// The constants of one branch, and the text around them. Empty if the form is not a choice, or if the branch
/// is as simple as u/s, which is in many formulas.
std::optional<SiteReader::Branch> SiteReader::branch(std::size_t part) const {
  constexpr std::size_t least_constants = 2;
  if (set_.formula.kind() != Symbolic::Kind::choice) return std::nullopt;
  Branch found{set_, {}, {}};
  found.set.formula = set_.formula.part(part);
  const std::set<std::string> names = names_of(found.set.formula);
  std::vector<std::size_t> literals;
  for (const SiteNumber& number : site_.numbers) {
    if (names.count(set_.constants[number.constant].name) == 0) continue;
    literals.push_back(number.literal);
    found.numbers.push_back(std::abs(constants_[number.constant]));
  }
  if (literals.size() < least_constants) return std::nullopt;
  found.expressions = expressions(literals_[literals.front()], literals_[literals.back()]);
  return found;
}

/// Whether the text around the constants of a branch computes that branch: pow((u + a)/b, p).
bool SiteReader::reads_branch(std::size_t part) const {
  const auto found = branch(part);
  return found &&
         std::any_of(found->expressions.begin(), found->expressions.end(), [&](const Symbolic& expression) {
           return is_form(expression, found->set, constants_, found->numbers);
         });
}

/// The form with a slip in one branch, if the branches are statements of their own.
std::optional<ExpressionMatch> SiteReader::slip_of_branch() const {
  if (!believes_slips()) return std::nullopt;
  for (const std::size_t part : branches) {
    const auto found = branch(part);
    if (!found) continue;
    std::optional<ExpressionMatch> slip;
    for (const Symbolic& expression : found->expressions) {
      auto match = match_expression(expression, found->set, constants_, found->numbers, {});
      if (match && match->slip.empty()) return std::nullopt;
      if (match && !slip) slip = std::move(match);
    }
    if (!slip) continue;
    std::vector<Symbolic> parts = set_.formula.parts();
    parts[part] = slip->form;
    slip->form = set_.formula.with_parts(std::move(parts));
    return slip;
  }
  return std::nullopt;
}

}  // namespace shadefit::lint
