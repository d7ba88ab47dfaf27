#include "lint/rival_sources.hpp"

#include <algorithm>

#include "lint/scan/digit_match.hpp"

namespace shadefit::lint {
namespace {

/// Whether the numbers fit another set: one with a slip, the others with fewer digits at most. Numbers with
/// more digits are not from there.
bool fits(std::string_view text, const KnownSet& set, const JudgedSite& site, const JudgedNumber& number) {
  return std::all_of(site.numbers.begin(), site.numbers.end(), [&](const JudgedNumber& one) {
    const auto match = match_digits(digits_of(text.substr(one.offset, one.length)),
                                    digits_of(set.constants[one.constant].printed));
    const bool is_changed = one.offset == number.offset;
    return match && *match != DigitMatch::longer && *match != DigitMatch::shifted &&
           (is_changed || *match <= DigitMatch::rounded);
  });
}

}  // namespace

bool has_rival_source(std::string_view text, const std::vector<KnownSet>& sets, const JudgedSite& site,
                      const JudgedNumber& number) {
  const KnownSet& set = sets[site.set];
  const auto is_source = [&](const KnownSet& other) {
    return other.id == set.id && other.times.empty() && set.times.empty();
  };
  const auto is_rival = [&](const KnownSet& other) {
    return other.form == set.form && other.constants.size() == set.constants.size() &&
           digits_of(other.constants[number.constant].printed) !=
               digits_of(set.constants[number.constant].printed) &&
           fits(text, other, site, number);
  };
  // The sources of a study stand beside each other.
  std::size_t first = site.set, end = site.set + 1;
  while (first > 0 && is_source(sets[first - 1])) --first;
  while (end < sets.size() && is_source(sets[end])) ++end;
  return std::any_of(sets.begin() + static_cast<std::ptrdiff_t>(first),
                     sets.begin() + static_cast<std::ptrdiff_t>(end), is_rival);
}

}  // namespace shadefit::lint
