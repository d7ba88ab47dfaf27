#include "lint/lint_text.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "lint/expression/calls.hpp"
#include "lint/scan/characters.hpp"
#include "lint/scan/lists.hpp"
#include "lint/site_judge.hpp"

namespace shadefit::lint {
namespace {

/// The constant of another source of the same form that a number of a site may be.
const KnownConstant& constant_of(const KnownSet& set, const KnownSet& other, const LintedNumber& number) {
  const auto constant = std::ranges::find(set.constants, number.constant, &KnownConstant::name);
  return other.constants[static_cast<std::size_t>(constant - set.constants.begin())];
}

/// Whether a number that is not right may as well be that of another source of the same form: 1.875996 for
/// 1.875991 or for 1.875992. The other numbers of the site have to fit that source too, with fewer digits at
/// most: numbers with more digits are not from there.
bool has_rival_source(const std::vector<KnownSet>& sets, std::size_t place, const LintedSite& site,
                      const LintedNumber& number) {
  const KnownSet& set = sets[place];
  const auto is_source = [&](const KnownSet& other) { return other.id == set.id; };
  const auto is_rival = [&](const KnownSet& other) {
    if (other.form != set.form || other.constants.size() != set.constants.size() ||
        digits_of(constant_of(set, other, number).printed) == digits_of(number.published))
      return false;
    return std::ranges::all_of(site.numbers, [&](const LintedNumber& one) {
      const auto match = match_digits(digits_of(one.text), digits_of(constant_of(set, other, one).printed));
      return match && *match != DigitMatch::longer && *match != DigitMatch::shifted &&
             (&one == &number || *match <= DigitMatch::rounded);
    });
  };
  // The sources of a study stand beside each other.
  std::size_t first = place, end = place + 1;
  while (first > 0 && is_source(sets[first - 1])) --first;
  while (end < sets.size() && is_source(sets[end])) ++end;
  return std::ranges::any_of(std::span(sets).subspan(first, end - first), is_rival);
}

/// Whether a number is the one argument of a function that is not a type: encode(0.0031308) is not a
/// threshold.
bool is_argument(std::string_view text, const Literal& literal) {
  const std::size_t open = begin_of_run(text, literal.offset, is_blank),
                    close = end_of_run(text, literal.offset + literal.length, is_blank);
  if (open == 0 || text[open - 1] != '(' || close == text.size() || text[close] != ')') return false;
  const std::size_t begin = begin_of_run(text, open - 1, is_of_name);
  return begin < open - 1 && !is_number_type(text.substr(begin, open - 1 - begin));
}

/// The site without digits of another formula that are the argument of its call.
Site without_arguments(Site site, const KnownSet& set, const ScannedText& text) {
  if (site.numbers.size() == 1) return site;
  std::erase_if(site.numbers, [&](const SiteNumber& number) {
    return number.variant && set.variants[*number.variant].is_borrowed &&
           is_argument(text.text, text.literals[number.literal]);
  });
  return site;
}

/// Whether a site before this one has the same number for the same study: the branches of one choice may be
/// sites of two of its sets.
bool is_said(const std::vector<LintedSite>& judged, const LintedSite& site) {
  return std::ranges::any_of(judged, [&](const LintedSite& other) {
    return other.id == site.id && std::ranges::any_of(other.numbers, [&](const LintedNumber& number) {
             return std::ranges::find(site.numbers, number.offset, &LintedNumber::offset) !=
                    site.numbers.end();
           });
  });
}

}  // namespace

std::vector<LintedSite> judge_text(std::string_view whole_text, CommentStyle style,
                                   const KnownConstants& known, const EffectLimits& limits,
                                   const Checkpoint& checkpoint) {
  const std::vector<Literal> literals = literals_of(whole_text, style);
  const ScannedText text{whole_text, style, literals};
  TextMemory memory;
  std::optional<std::string> code;
  const auto program_of = [&](const Site& site) {
    if (text.literals[site.numbers.front().literal].is_in_comment) return text;
    if (!code) code = with_blank_comments(text.text, text.style);
    return ScannedText{*code, text.style, text.literals};
  };
  const auto reading = [&](const Site& site) {
    checkpoint();
    return reading_of(program_of(site), known.sets[site.set], site, memory);
  };
  std::vector<LintedSite> judged;
  for (const Site& whole : sites_of(text, known.sets, known.index, reading)) {
    checkpoint();
    const KnownSet& set = known.sets[whole.set];
    const Site site = without_arguments(whole, set, text);
    const ScannedText program = program_of(site);
    auto one = judge_site(text, program, set, site, limits, memory);
    if (!one || is_said(judged, *one)) continue;
    one->is_in_table = set.constants.size() < least_table &&
                       is_in_table(text, site.numbers.front().literal, site.numbers.back().literal);
    for (LintedNumber& number : one->numbers)
      if (number.grade != Grade::right && has_rival_source(known.sets, whole.set, *one, number))
        number.is_certain = false;
    judged.push_back(std::move(*one));
  }
  return judged;
}

}  // namespace shadefit::lint
