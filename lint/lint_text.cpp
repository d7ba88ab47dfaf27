#include "lint/lint_text.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lint/expression/joined_strings.hpp"
#include "lint/expression/usual_names.hpp"
#include "lint/number_table.hpp"
#include "lint/rival_sources.hpp"
#include "lint/scan/characters.hpp"
#include "lint/scan/lists.hpp"
#include "lint/scan/named_numbers.hpp"
#include "lint/site_reader.hpp"

namespace shadefit::lint {
namespace {

void sort_by_place(std::vector<JudgedNumber>& numbers) {
  std::sort(numbers.begin(), numbers.end(),
            [](const JudgedNumber& a, const JudgedNumber& b) { return a.offset < b.offset; });
}

/// Adds a number, if there is one, at its place.
void add(std::optional<JudgedNumber> number, std::vector<JudgedNumber>& numbers) {
  if (number) numbers.push_back(std::move(*number));
  sort_by_place(numbers);
}

/// What is computed once for a text.
struct TextMemory {
  ReadingMemory readings;
  KnownEffects effects;
};

/// A text, its numbers, and a site in it.
class SiteJudge {
 public:
  /// `program` is the text with_joined_strings().
  SiteJudge(std::string_view text, std::string_view program, CommentStyle style,
            const std::vector<Literal>& literals, const KnownSet& set, const Site& site, TextMemory& memory)
      : text_(text),
        literals_(literals),
        set_(set),
        site_(site),
        reader_(program, style, literals, set, site, memory.readings),
        effects_(memory.effects) {}

  /// The site, or empty if neither its numbers nor the expression around them show that it is one.
  std::optional<JudgedSite> judge(const EffectLimits& limits) const {
    auto read = reader_.read();
    const bool is_read = read.has_value();
    if (!read && site_.bits < telling_bits) return std::nullopt;
    const auto in_order = is_read ? std::nullopt : literal_in_order();
    if (in_order) read = replaced_by(*in_order);
    JudgedSite judged;
    judged.set = site_.set;
    judged.numbers = judged_numbers();
    const ExpressionMatch found = read.value_or(ExpressionMatch{set_.formula, reader_.constants()});
    judged.graded = grade_of(set_, site_, found, limits, effects_);
    if (found.replaced) add(replacing(found, in_order), judged.numbers);
    if (found.is_published)
      for (JudgedNumber& number : judged.numbers) number.grade = Grade::right;
    judged.slip = found.slip;
    judged.is_read = is_read;
    judged.is_in_comment =
        std::all_of(site_.numbers.begin(), site_.numbers.end(),
                    [&](const SiteNumber& number) { return literals_[number.literal].is_in_comment; });
    // A comment without a formula may wrap a number or mention an older one, unless it has the whole set.
    if (judged.is_in_comment && !is_read && judged.graded.grade != Grade::right && !is_whole_set())
      return std::nullopt;
    for (const SiteNumber& number : site_.numbers)
      if (number.variant) judged.replaced = set_.variants[*number.variant].replaced;
    return judged;
  }

 private:
  /// Whether all constants are there with as many digits as published, right or wrong.
  bool is_whole_set() const {
    return site_.numbers.size() == set_.constants.size() &&
           std::all_of(site_.numbers.begin(), site_.numbers.end(), [&](const SiteNumber& number) {
             return number.match <= DigitMatch::float32 ||
                    literals_[number.literal].digits.text.size() ==
                        digits_of(set_.constants[number.constant].printed).text.size();
           });
  }

  std::vector<JudgedNumber> judged_numbers() const {
    const bool has_other_units = is_in_other_units(site_);
    std::vector<JudgedNumber> numbers;
    for (const SiteNumber& number : site_.numbers) {
      const Digits published = digits_of(set_.constants[number.constant].printed);
      const bool is_shifted = number.match == DigitMatch::shifted;
      const bool is_of_units =
          has_other_units &&
          (is_shifted || !have_near_exponents(literals_[number.literal].digits, published));
      const Grade grade = is_of_units && is_shifted ? Grade::right : lint::grade_of(set_, number);
      if (is_by_expression(number)) {
        const double found = number_of(literals_[number.literal].digits);
        numbers.push_back(by_expression(number.constant, found, grade).value());
        continue;
      }
      std::vector<std::size_t> at;
      for (std::size_t i = number.literal - number.repeats; i <= number.literal; ++i) at.push_back(i);
      numbers.push_back(judged_number(at, number.constant, grade));
      if (is_of_units) numbers.back().evidence = NumberEvidence::none;
    }
    return numbers;
  }

  /// Whether the digits do not show which constant a number is: two slips in three digits.
  bool is_by_expression(const SiteNumber& number) const {
    return number.match == DigitMatch::edited && !number.variant &&
           digits_of(set_.constants[number.constant].printed).text.size() < least_digits_to_vary;
  }

  /// A number at these literals. Its place is the last one.
  JudgedNumber judged_number(const std::vector<std::size_t>& at, std::size_t constant, Grade grade) const {
    const auto place = [&](std::size_t i) { return NumberPlace{literals_[i].offset, literals_[i].length}; };
    JudgedNumber number{place(at.back()), constant, grade};
    for (std::size_t i = 0; i + 1 < at.size(); ++i) number.copies.push_back(place(at[i]));
    return number;
  }

  /// The number that is a constant by the expression alone. Empty if no number near has this value.
  std::optional<JudgedNumber> by_expression(std::size_t constant, double value, Grade grade) const {
    const FoundLiterals found = reader_.literals_of(constant, value);
    if (found.literals.empty()) return std::nullopt;
    JudgedNumber number = judged_number(found.literals, constant, grade);
    number.evidence = found.are_certain ? NumberEvidence::expression : NumberEvidence::none;
    return number;
  }

  /// The number that replaces a constant: in the published order, or by the expression.
  std::optional<JudgedNumber> replacing(const ExpressionMatch& match,
                                        const std::optional<std::size_t>& in_order) const {
    const std::size_t constant = *match.replaced;
    const double value = std::abs(match.constants[constant]);
    const Grade grade = grade_of_other(set_.constants[constant], value);
    return in_order ? judged_number({*in_order}, constant, grade) : by_expression(constant, value, grade);
  }

  /// If the published order is kept and one constant inside it is missing, the only number between its
  /// neighbours replaces it: vec4(1, 0.0425, 1.0, -0.04).
  std::optional<std::size_t> literal_in_order() const {
    constexpr std::size_t least_constants = 5;  // with fewer, the order says little
    const std::vector<std::size_t>& missing = reader_.missing();
    if (missing.size() != 1 || set_.constants.size() < least_constants) return std::nullopt;
    for (std::size_t i = 1; i < site_.numbers.size(); ++i)
      if (site_.numbers[i].constant <= site_.numbers[i - 1].constant) return std::nullopt;
    const std::size_t place = missing.front();
    if (place == 0 || place + 1 == set_.constants.size()) return std::nullopt;
    const std::size_t before = site_.numbers[place - 1].literal, behind = site_.numbers[place].literal;
    const Literal& literal = literals_[before + 1];
    if (behind != before + 2 || literal.is_in_comment != literals_[before].is_in_comment ||
        !stands_alone(text_, literal))
      return std::nullopt;
    return before + 1;
  }

  /// The form with this number in place of the only missing constant.
  ExpressionMatch replaced_by(std::size_t literal) const {
    const std::size_t constant = reader_.missing().front();
    std::vector<double> found = reader_.constants();
    found[constant] = std::copysign(number_of(literals_[literal].digits), found[constant]);
    return {.form = set_.formula, .constants = found, .replaced = constant};
  }

  std::string_view text_;
  const std::vector<Literal>& literals_;
  const KnownSet& set_;
  const Site& site_;
  SiteReader reader_;
  KnownEffects& effects_;
};

/// Whether a number is the one argument of a function that is not a type: encode(0.0031308) is not a
/// threshold.
bool is_argument(std::string_view text, const Literal& literal) {
  std::size_t end = literal.offset, next = literal.offset + literal.length;
  while (end > 0 && is_blank(text[end - 1])) --end;
  while (next < text.size() && is_blank(text[next])) ++next;
  if (end == 0 || text[end - 1] != '(' || next == text.size() || text[next] != ')') return false;
  std::size_t begin = --end;
  while (begin > 0 && is_of_name(text[begin - 1])) --begin;
  return begin < end && !is_number_type(text.substr(begin, end - begin));
}

/// The site without digits of another formula that are the argument of its call.
Site without_arguments(Site site, const KnownSet& set, std::string_view text,
                       const std::vector<Literal>& literals) {
  if (site.numbers.size() == 1) return site;
  std::erase_if(site.numbers, [&](const SiteNumber& number) {
    return number.variant && set.variants[*number.variant].is_borrowed &&
           is_argument(text, literals[number.literal]);
  });
  return site;
}

std::vector<JudgedSite> judge_literals(std::string_view text, CommentStyle style,
                                       const std::vector<Literal>& literals, const KnownConstants& known,
                                       const EffectLimits& limits, TextMemory& memory,
                                       const Checkpoint& checkpoint) {
  const std::string program = with_joined_strings(text, style);
  const auto reading = [&](const Site& site) {
    checkpoint();
    return SiteReader(program, style, literals, known.sets[site.set], site, memory.readings).reading();
  };
  std::vector<JudgedSite> judged;
  for (const Site& whole : sites_of(text, literals, known.sets, known.index, reading)) {
    checkpoint();
    const KnownSet& set = known.sets[whole.set];
    const Site site = without_arguments(whole, set, text, literals);
    const SiteJudge judge(text, program, style, literals, set, site, memory);
    auto one = judge.judge(limits);
    if (!one) continue;
    one->is_in_table =
        set.constants.size() < least_table &&
        is_in_table(text, style, literals, site.numbers.front().literal, site.numbers.back().literal);
    for (JudgedNumber& number : one->numbers)
      if (number.grade != Grade::right && has_rival_source(text, known.sets, *one, number))
        number.evidence = NumberEvidence::none;
    judged.push_back(std::move(*one));
  }
  return judged;
}

bool has_number(const JudgedSite& site, const JudgedNumber& number) {
  return std::any_of(site.numbers.begin(), site.numbers.end(),
                     [&](const JudgedNumber& other) { return other.offset == number.offset; });
}

/// Whether one site has all numbers of another.
bool covers(const JudgedSite& site, const JudgedSite& other) {
  return std::all_of(other.numbers.begin(), other.numbers.end(),
                     [&](const JudgedNumber& number) { return has_number(site, number); });
}

/// The site with the places in the original text.
JudgedSite in_original(JudgedSite site, const TextWithNumbers& with_numbers) {
  for (JudgedNumber& number : site.numbers) {
    // The name may mean something else where it is used again.
    if (number.evidence == NumberEvidence::expression && with_numbers.is_named(number.offset) &&
        with_numbers.count_uses(number.offset) > 1 + number.copies.size())
      number.evidence = NumberEvidence::none;
    number.offset = with_numbers.original(number.offset);
    for (NumberPlace& copy : number.copies) copy.offset = with_numbers.original(copy.offset);
  }
  sort_by_place(site.numbers);
  return site;
}

}  // namespace

std::vector<JudgedSite> judge_text(std::string_view text, CommentStyle style, const KnownConstants& known,
                                   const EffectLimits& limits, const Checkpoint& checkpoint) {
  const std::vector<Literal> literals = literals_of(text, style);
  TextMemory memory;
  std::vector<JudgedSite> sites = judge_literals(text, style, literals, known, limits, memory, checkpoint);
  // Half of all numbers of three digits are near a constant.
  constexpr std::size_t least_digits = 4;
  const auto is_telling = [&](const Literal& literal) {
    const std::vector<NumberMatch> matches = known.index.find(literal.digits);
    return std::any_of(matches.begin(), matches.end(), [&](const NumberMatch& match) {
      return match.match == DigitMatch::same || literal.significant >= least_digits;
    });
  };
  const auto with_numbers = with_named_numbers(text, style, literals, is_telling);
  if (!with_numbers) return sites;
  const std::string& other = with_numbers->text();
  for (JudgedSite& one :
       judge_literals(other, style, literals_of(other, style), known, limits, memory, checkpoint)) {
    const bool has_names =
        std::any_of(one.numbers.begin(), one.numbers.end(),
                    [&](const JudgedNumber& number) { return with_numbers->is_named(number.offset); });
    if (!one.is_read || !has_names) continue;
    JudgedSite site = in_original(std::move(one), *with_numbers);
    // The formula tells more than the definitions alone. Its next copy tells nothing new.
    const bool is_copy = std::any_of(sites.begin(), sites.end(), [&](const JudgedSite& before) {
      return before.is_read && before.set == site.set && covers(before, site);
    });
    if (is_copy) continue;
    std::erase_if(sites, [&](const JudgedSite& before) { return covers(site, before); });
    sites.push_back(std::move(site));
  }
  std::stable_sort(sites.begin(), sites.end(), [](const JudgedSite& a, const JudgedSite& b) {
    return a.numbers.front().offset < b.numbers.front().offset;
  });
  return sites;
}

}  // namespace shadefit::lint
