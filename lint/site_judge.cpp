#include "lint/site_judge.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "lint/expression/source_expression.hpp"
#include "lint/scan/lists.hpp"

namespace shadefit::lint {
namespace {

/// The text of an expression with names by the order of their places: two expressions that differ in their
/// names alone have one text.
std::string text_without_names(const Symbolic& expression) {
  std::map<std::string, std::string> names;
  return to_text(evaluate<Symbolic>(expression, [&](const std::string& name) {
    const auto [place, is_new] = names.emplace(name, "");
    if (is_new) place->second = "v" + std::to_string(names.size());
    return Symbolic::variable(place->second);
  }));
}

/// A wrong expression counts only if numbers and operations are evidence enough. Two of some 100 slips of
/// some 100 forms fit by chance in one of 2^13 cases, and the median form has 6 operations, one bit for each.
constexpr double bits_for_a_slip = 13 + 6;

std::vector<Symbolic> expressions_in(std::string_view text, std::size_t begin, std::size_t end,
                                     CommentStyle style, TextMemory& memory) {
  const auto read = [&](std::string_view one, CommentStyle as) {
    return memory.expressions.get({as, std::string(one)}, [&] { return read_expression(one, as); });
  };
  std::vector<Symbolic> found;
  for (const std::string_view one : expressions_around(text, begin, end))
    if (auto expression = read(one, style)) found.push_back(std::move(*expression));
  for (Symbolic& value : values_around(text, begin, end, style, read)) found.push_back(std::move(value));
  return found;
}

/// The literals that stand for a constant, by their indices.
struct FoundLiterals {
  std::vector<std::size_t> literals;
  bool are_certain = false;
};

/// Judges a site in a text, by reading the program around it as the form of its set.
class SiteJudge {
 public:
  SiteJudge(const ScannedText& text, const ScannedText& program, const KnownSet& set, const Site& site,
            TextMemory& memory)
      : text_(text),
        program_(program),
        set_(set),
        site_(site),
        memory_(memory),
        constants_(constants_at(set, site, text.literals)),
        missing_(missing_constants(set, site)) {}

  /// How much of the form the text contains.
  Reading reading() const {
    const std::size_t count = site_.numbers.size();
    if (const auto match = read(); match && match->slip.empty())
      return {Reading::Part::form, count + (match->replaced ? 1 : 0)};
    const bool has_branch = reads_branch(2) || reads_branch(3);  // the parts of a choice behind its condition
    return {has_branch ? Reading::Part::branch : Reading::Part::nothing, count};
  }

  std::optional<LintedSite> judge(const EffectLimits& limits) const {
    auto match = read();
    const bool is_read = match.has_value();
    if (!is_read && site_.bits < telling_bits) return std::nullopt;
    const auto in_order = is_read ? std::nullopt : literal_in_order();
    if (in_order) match = replaced_by(*in_order);
    const ExpressionMatch found = match.value_or(ExpressionMatch{set_.formula, constants_});
    LintedSite judged = graded_site(set_, site_, found, limits, memory_.effects);
    judged.numbers = judged_numbers();
    if (found.replaced) {
      if (auto number = replacing(found, in_order)) judged.numbers.push_back(std::move(*number));
      std::ranges::sort(judged.numbers, {}, &LintedNumber::offset);
    }
    if (found.is_published)
      for (LintedNumber& number : judged.numbers) number.grade = Grade::right;
    judged.slip = found.slip;
    judged.is_in_comment = std::ranges::all_of(
        site_.numbers, [&](const SiteNumber& number) { return at(number.literal).is_in_comment; });
    // A comment without a formula may wrap a number or mention an older one.
    if (judged.is_in_comment && !is_read && judged.grade != Grade::right) return std::nullopt;
    for (const SiteNumber& number : site_.numbers)
      if (number.variant) judged.replaced = set_.variants[*number.variant].replaced;
    return judged;
  }

 private:
  /// The smallest expression around the numbers that is the form, one of its mixed forms, or one of them with
  /// a slip. Empty if there is none, if more than one constant is missing that a program must have, or if the
  /// numbers are in other units.
  std::optional<ExpressionMatch> read() const {
    if (is_in_other_units(site_)) return std::nullopt;
    std::vector<double> numbers;
    for (const SiteNumber& number : site_.numbers) numbers.push_back(std::abs(constants_[number.constant]));
    KnownSet set = set_;
    std::optional<ExpressionMatch> slip;
    for (std::size_t form = 0; form <= set_.mixed.size(); ++form) {
      if (form > 0) set.formula = set_.mixed[form - 1];
      if (lacks_constants(set.formula)) continue;
      for (const Symbolic& one : expressions(site_.numbers.front().literal, site_.numbers.back().literal)) {
        const auto key = std::tuple(&set_, form, text_without_names(one), constants_, numbers, missing_);
        auto match = memory_.matches.get(
            key, [&] { return match_expression(one, set, constants_, numbers, missing_); });
        if (!match) continue;
        if (match->slip.empty()) return match;
        if (!slip && believes_slips()) slip = std::move(match);
      }
    }
    if (!slip && !lacks_constants(set_.formula)) slip = slip_of_branch();
    return slip;
  }

  /// The literals of a constant that has this value at the site, and that only the expression shows: the
  /// nearest one, or several in a row, as in vec3(0.4, 0.4, 0.4). They are certain if no other literal near
  /// has this value.
  FoundLiterals literals_of(std::size_t constant, double value) const {
    constexpr std::size_t most_literals = 8;
    const std::size_t first = site_.numbers.front().literal, last = site_.numbers.back().literal;
    const auto is_taken = [&](std::size_t i) {
      return std::ranges::any_of(site_.numbers, [&](const SiteNumber& number) {
        return number.literal == i && number.constant != constant;
      });
    };
    std::vector<std::size_t> near;
    for (std::size_t i = first - std::min(first, most_literals);
         i < std::min(program_.literals.size(), last + most_literals); ++i)
      if (!is_taken(i) && number_of(program_.literals[i].digits) == value) near.push_back(i);
    if (near.empty()) return {};
    if (near.back() - near.front() + 1 == near.size()) return {std::move(near), true};
    const auto distance = [&](std::size_t i) {  // in bytes
      return i < first ? program_.literals[first].offset - program_.literals[i].offset
                       : program_.literals[i].offset - program_.literals[std::min(i, last)].offset;
    };
    return {{*std::ranges::min_element(near, {}, distance)}, false};
  }

  bool believes_slips() const {
    return site_.numbers.size() > 1 && site_.bits + count_operations(set_.formula).total() >= bits_for_a_slip;
  }

  /// Whether more than one constant of a formula is missing that a program must have, unlike 1 or pi/2. Then
  /// no expression can be the form.
  bool lacks_constants(const Symbolic& formula) const {
    const std::set<std::string> names = names_of(formula);
    return std::ranges::count_if(missing_, [&](std::size_t constant) {
             return !set_.constants[constant].is_common && names.contains(set_.constants[constant].name);
           }) > 1;
  }

  /// The values that are computed around the numbers: first in one statement, then in several.
  std::vector<Symbolic> expressions(std::size_t first, std::size_t last) const {
    const auto& [text, style, literals] = program_;
    const std::size_t begin = literals[first].offset, end = literals[last].offset + literals[last].length;
    if (!literals[first].is_in_comment) return expressions_in(text, begin, end, style, memory_);
    constexpr std::size_t most_bytes_around = 700;
    const std::size_t start = begin - std::min(begin, most_bytes_around);
    const std::string program = comment_as_program(text.substr(start, end - start + most_bytes_around));
    return expressions_in(program, begin - start, end - start, CommentStyle::none, memory_);
  }

  /// One branch of a choice as a set of its own, with those of its numbers that are at the site.
  struct Branch {
    KnownSet set;
    std::vector<double> numbers;
    std::vector<Symbolic> expressions;  ///< around them
  };

  /// Empty if the form is not a choice, or if the branch is as simple as u/s, which is in many formulas.
  std::optional<Branch> branch(std::size_t part) const {
    constexpr std::size_t least_constants = 2;
    if (set_.formula.kind() != Symbolic::Kind::choice) return std::nullopt;
    Branch found{set_, {}, {}};
    found.set.formula = set_.formula.part(part);
    const std::set<std::string> names = names_of(found.set.formula);
    std::vector<std::size_t> literals;
    for (const SiteNumber& number : site_.numbers) {
      if (!names.contains(set_.constants[number.constant].name)) continue;
      literals.push_back(number.literal);
      found.numbers.push_back(std::abs(constants_[number.constant]));
    }
    if (literals.size() < least_constants) return std::nullopt;
    found.expressions = expressions(literals.front(), literals.back());
    return found;
  }

  /// Whether the text around the constants of a branch computes that branch: pow((u + a)/b, p).
  bool reads_branch(std::size_t part) const {
    const auto found = branch(part);
    return found && std::ranges::any_of(found->expressions, [&](const Symbolic& expression) {
             return is_form(expression, found->set, constants_, found->numbers);
           });
  }

  /// The form with a slip in one branch, if the branches are statements of their own.
  std::optional<ExpressionMatch> slip_of_branch() const {
    if (!believes_slips()) return std::nullopt;
    for (const std::size_t part : {std::size_t{2}, std::size_t{3}}) {
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

  const Literal& at(std::size_t literal) const { return text_.literals[literal]; }

  std::vector<LintedNumber> judged_numbers() const {
    const bool has_other_units = is_in_other_units(site_);
    std::vector<LintedNumber> numbers;
    for (const SiteNumber& number : site_.numbers) {
      const bool is_shifted = number.match == DigitMatch::shifted;
      const Digits published = digits_of(set_.constants[number.constant].printed);
      const bool is_of_units =
          has_other_units && (is_shifted || !have_near_exponents(at(number.literal).digits, published));
      const Grade grade = is_of_units && is_shifted ? Grade::right : lint::grade_of(set_, number);
      std::vector<std::size_t> places(number.repeats + 1);
      std::iota(places.begin(), places.end(), number.literal - number.repeats);
      numbers.push_back(judged_number(places, number.constant, grade));
      numbers.back().is_certain = !is_of_units;
    }
    return numbers;
  }

  /// A number at these literals. Its place is the last one.
  LintedNumber judged_number(const std::vector<std::size_t>& places, std::size_t constant,
                             Grade grade) const {
    LintedNumber number{set_.constants[constant].name, set_.constants[constant].printed, "", grade, 0, true};
    for (const std::size_t i : places)
      number.copies.push_back({at(i).offset, std::string(text_.text.substr(at(i).offset, at(i).length))});
    number.offset = number.copies.back().offset;
    number.text = number.copies.back().text;
    number.copies.pop_back();
    return number;
  }

  /// The number that replaces a constant: in the published order, or by the expression.
  std::optional<LintedNumber> replacing(const ExpressionMatch& match,
                                        const std::optional<std::size_t>& in_order) const {
    const std::size_t constant = *match.replaced;
    const double value = std::abs(match.constants[constant]);
    const Grade grade = grade_of_other(set_.constants[constant], value);
    if (in_order) return judged_number({*in_order}, constant, grade);
    const FoundLiterals found = literals_of(constant, value);
    if (found.literals.empty()) return std::nullopt;
    LintedNumber number = judged_number(found.literals, constant, grade);
    number.is_certain = found.are_certain;
    return number;
  }

  /// If the published order is kept and one constant inside it is missing, the only number between its
  /// neighbours replaces it: vec4(1, 0.0425, 1.0, -0.04).
  std::optional<std::size_t> literal_in_order() const {
    constexpr std::size_t least_constants = 5;  // with fewer, the order says little
    if (missing_.size() != 1 || set_.constants.size() < least_constants) return std::nullopt;
    for (std::size_t i = 1; i < site_.numbers.size(); ++i)
      if (site_.numbers[i].constant <= site_.numbers[i - 1].constant) return std::nullopt;
    const std::size_t place = missing_.front();
    if (place == 0 || place + 1 == set_.constants.size()) return std::nullopt;
    const std::size_t before = site_.numbers[place - 1].literal, behind = site_.numbers[place].literal;
    const Literal& literal = at(before + 1);
    if (behind != before + 2 || literal.is_in_comment != at(before).is_in_comment ||
        !stands_alone(text_.text, literal))
      return std::nullopt;
    return before + 1;
  }

  /// The form with this number in place of the only missing constant.
  ExpressionMatch replaced_by(std::size_t literal) const {
    const std::size_t constant = missing_.front();
    std::vector<double> found = constants_;
    found[constant] = std::copysign(number_of(at(literal).digits), found[constant]);
    return {.form = set_.formula, .constants = found, .replaced = constant};
  }

  const ScannedText &text_, &program_;
  const KnownSet& set_;
  const Site& site_;
  TextMemory& memory_;
  std::vector<double> constants_;     ///< as found: see constants_at()
  std::vector<std::size_t> missing_;  ///< the set's constants that are not at the site
};

}  // namespace

Reading reading_of(const ScannedText& program, const KnownSet& set, const Site& site, TextMemory& memory) {
  return SiteJudge(program, program, set, site, memory).reading();
}

std::optional<LintedSite> judge_site(const ScannedText& text, const ScannedText& program, const KnownSet& set,
                                     const Site& site, const EffectLimits& limits, TextMemory& memory) {
  return SiteJudge(text, program, set, site, memory).judge(limits);
}

}  // namespace shadefit::lint
