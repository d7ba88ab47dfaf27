#include "lint/scan/companions.hpp"

#include <algorithm>
#include <utility>

#include "lint/scan/digit_match.hpp"
#include "lint/scan/functions.hpp"
#include "lint/scan/lists.hpp"

namespace shadefit::lint {
namespace {

void insert(Site& site, const SiteNumber& number) {
  const auto behind = std::find_if(site.numbers.begin(), site.numbers.end(),
                                   [&](const SiteNumber& other) { return other.literal > number.literal; });
  site.numbers.insert(behind, number);
}

/// Whether the site's constants stay in the published order with this constant at this literal.
bool keeps_order(const Site& site, std::size_t constant, std::size_t literal) {
  return std::all_of(site.numbers.begin(), site.numbers.end(), [&](const SiteNumber& number) {
    return (number.constant < constant) == (number.literal < literal);
  });
}

bool has_constant(const Site& site, std::size_t constant) {
  return std::any_of(site.numbers.begin(), site.numbers.end(),
                     [&](const SiteNumber& number) { return number.constant == constant; });
}
bool is_taken(const Site& site, std::size_t literal) {
  return std::any_of(site.numbers.begin(), site.numbers.end(),
                     [&](const SiteNumber& number) { return number.literal == literal; });
}

}  // namespace

void Companions::add_near(Site& site) {
  constexpr std::size_t most_literals = 6;
  const std::size_t first = site.numbers.front().literal, last = site.numbers.back().literal;
  const std::size_t begin = first - std::min(first, most_literals),
                    end = std::min(literals_.size(), last + most_literals + 1);
  const KnownSet& set = sets_[site.set];
  const auto matched = [&](std::size_t i, const Digits& published, std::size_t enough) {
    const Digits& found = digits_at(i);
    if (found == published) return std::optional(DigitMatch::same);
    return set.times.empty() ? std::nullopt : match_multiple(found, published, enough);
  };
  const auto is_near = [&](std::size_t i) {
    return literals_[i].offset + most_gap > literals_[first].offset &&
           literals_[i].offset < literals_[last].offset + most_gap && !is_taken(site, i) &&
           literals_[i].is_in_comment == literals_[first].is_in_comment;
  };
  for (std::size_t c = 0; c < set.constants.size(); ++c) {
    if (has_constant(site, c)) continue;
    const KnownConstant& constant = set.constants[c];
    const Digits published = digits_of(constant.printed);
    // First by the published order, then by distance: a 1 may be anywhere.
    const auto place_of = [&](std::size_t i) {
      return std::pair(!keeps_order(site, c, i), i < first ? first - i : i - std::min(i, last));
    };
    std::optional<SiteNumber> any;
    for (std::size_t i = begin; i < end; ++i) {
      if (!is_near(i)) continue;
      const auto match = matched(i, published, constant.enough_digits);
      if (match && are_in_one_function(i, first) && (!any || place_of(i) < place_of(any->literal)))
        any = SiteNumber{i, c, *match};
    }
    if (any) site.numbers.push_back(*any);
  }
  std::sort(site.numbers.begin(), site.numbers.end(),
            [](const SiteNumber& a, const SiteNumber& b) { return a.literal < b.literal; });
}

void Companions::add_short(Site& site) const {
  const std::vector<std::size_t> missing = missing_of(site);
  if (missing.size() != 1) return;
  const std::size_t constant = missing.front();
  const std::size_t first = site.numbers.front().literal, last = site.numbers.back().literal;
  const Digits published = digits_of(sets_[site.set].constants[constant].printed);
  for (std::size_t i = first - std::min<std::size_t>(first, 1); i < std::min(literals_.size(), last + 2);
       ++i) {
    const std::size_t begin = std::min(first, i), end = std::max(last, i);
    if (literals_[i].significant >= least_digits_alone || is_taken(site, i) ||
        end - begin != site.numbers.size() || literals_[i].is_in_comment != literals_[first].is_in_comment ||
        !keeps_order(site, constant, i) || !is_shortened(digits_at(i), published) ||
        !have_same_decimals(text_, literals_, begin, end) || !is_whole_list(text_, literals_, begin, end))
      continue;
    insert(site, {i, constant, DigitMatch::rounded});
    return;
  }
}

bool Companions::add_wrong(Site& site) {
  const bool is_changed = add_rounded_and_edited(site);
  return take_edited_repetitions(site) || is_changed;
}

void Companions::add_two_slips(Site& site) {
  constexpr std::size_t most_literals = 6;
  std::vector<std::size_t> missing = missing_of(site);
  std::erase_if(missing, [&](std::size_t c) { return sets_[site.set].constants[c].is_common; });
  if (missing.size() != 2) return;
  Site whole = site;
  const std::size_t first = site.numbers.front().literal, last = site.numbers.back().literal;
  for (const std::size_t constant : missing) {
    const Digits published = digits_of(sets_[site.set].constants[constant].printed);
    if (published.text.size() != least_digits_alone) return;
    const auto distance = [&](std::size_t i) { return i < first ? first - i : i - std::min(i, last); };
    std::optional<std::size_t> nearest;
    for (std::size_t i = first - std::min(first, most_literals);
         i < std::min(literals_.size(), last + most_literals + 1); ++i) {
      if (is_taken(whole, i) || literals_[i].is_in_comment != literals_[first].is_in_comment ||
          !are_in_one_function(i, first) || !is_usual_slip(digits_at(i), published))
        continue;
      if (!nearest || distance(i) < distance(*nearest)) nearest = i;
    }
    if (!nearest) return;
    insert(whole, {*nearest, constant, DigitMatch::edited});
  }
  site = std::move(whole);
}

bool Companions::are_in_one_function(std::size_t a, std::size_t b) {
  if (!functions_) functions_ = function_begins(text_);
  const auto behind = [&](std::size_t literal) {
    return std::upper_bound(functions_->begin(), functions_->end(), literals_[literal].offset);
  };
  return behind(a) == behind(b);
}

bool Companions::add_rounded_and_edited(Site& site) {
  const std::size_t count = site.numbers.size();
  const std::size_t first = site.numbers.front().literal, last = site.numbers.back().literal;
  const KnownSet& set = sets_[site.set];
  const bool has_other_units = is_in_other_units(site);
  const auto is_edited_in_other_units = [&](const Digits& found, const Digits& published) {
    return has_other_units && match_digits({found.text, published.exponent}, published) == DigitMatch::edited;
  };
  for (std::size_t c = 0; c < set.constants.size(); ++c) {
    if (set.constants[c].is_common || has_constant(site, c)) continue;
    const Digits published = digits_of(set.constants[c].printed);
    for (std::size_t i = first - std::min<std::size_t>(first, 1);
         i < std::min(literals_.size(), last + 2) && !has_constant(site, c); ++i) {
      if (is_taken(site, i) || !keeps_order(site, c, i) || !are_in_one_function(i, first) ||
          literals_[i].is_in_comment != literals_[first].is_in_comment)
        continue;
      // The index does not look for multiples of few digits, nor for edited ones.
      const auto match = set.times.empty() ? std::nullopt : match_digits(digits_at(i), published);
      if (match && *match != DigitMatch::shifted)
        site.numbers.push_back({i, c, *match});
      else if (is_rounded_and_edited(digits_at(i), published))
        site.numbers.push_back({i, c, DigitMatch::rounded_and_edited});
      else if (is_edited_in_other_units(digits_at(i), published))
        site.numbers.push_back({i, c, DigitMatch::edited});
    }
  }
  std::sort(site.numbers.begin(), site.numbers.end(),
            [](const SiteNumber& a, const SiteNumber& b) { return a.literal < b.literal; });
  return site.numbers.size() > count;
}

bool Companions::take_edited_repetitions(Site& site) {
  constexpr std::size_t least_repeated = 5;  // one of 100 such numbers has one edit
  const std::size_t first = site.numbers.front().literal, last = site.numbers.back().literal;
  bool is_changed = false;
  if (!sets_[site.set].times.empty()) return false;
  for (SiteNumber& number : site.numbers) {
    const KnownConstant& constant = sets_[site.set].constants[number.constant];
    const Digits published = digits_of(constant.printed);
    if (!constant.is_repeated || constant.is_common || number.match > DigitMatch::float32 ||
        published.text.size() < least_repeated)
      continue;
    for (std::size_t i = first; i <= last; ++i) {
      const auto match = match_digits(digits_at(i), published);
      if ((match != DigitMatch::edited && match != DigitMatch::shifted) || is_taken(site, i) ||
          literals_[i].is_in_comment != literals_[number.literal].is_in_comment)
        continue;
      number = {i, number.constant, *match};
      is_changed = true;
      break;
    }
  }
  std::sort(site.numbers.begin(), site.numbers.end(),
            [](const SiteNumber& a, const SiteNumber& b) { return a.literal < b.literal; });
  return is_changed;
}

std::vector<std::size_t> Companions::missing_of(const Site& site) const {
  std::vector<std::size_t> missing;
  for (std::size_t c = 0; c < sets_[site.set].constants.size(); ++c)
    if (!has_constant(site, c)) missing.push_back(c);
  return missing;
}

}  // namespace shadefit::lint
