#include "lint/scan/sites.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <tuple>
#include <utility>

namespace shadefit::lint {
namespace {

/// Constants of one formula stand within that many bytes of each other.
constexpr std::size_t most_gap = 700;

/// A number of fewer digits is looked for only near the other constants.
constexpr std::size_t least_digits_alone = 3;

struct Hit {
  std::size_t set, literal;
  NumberMatch match;
};

std::vector<Hit> hits_of(std::string_view text, const std::vector<Literal>& literals,
                         const DigitIndex& index) {
  std::vector<Hit> hits;
  for (std::size_t i = 0; i < literals.size(); ++i) {
    if (literals[i].significant < least_digits_alone) continue;
    for (NumberMatch match : index.find(digits_of(text, literals[i]))) {
      if (match.match == DigitMatch::shifted && literals[i].has_power_of_ten) match.match = DigitMatch::same;
      hits.push_back({match.place.set, i, match});
    }
  }
  // Of several constants of a set that a number may stand for, the closest comes first.
  std::stable_sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
    return std::tuple(a.set, a.literal, a.match.match) < std::tuple(b.set, b.literal, b.match.match);
  });
  return hits;
}

class SiteFinder {
 public:
  SiteFinder(std::string_view text, const std::vector<Literal>& literals, const std::vector<KnownSet>& sets)
      : text_(text), literals_(literals), sets_(sets) {}

  /// Takes the hits of one number, and of one set, in order. A constant that comes again begins the next
  /// site, and so does every number behind a complete one: the next copy of the formula may be the wrong one.
  void add(std::span<const Hit> hits) {
    const Hit& first = hits.front();
    if (!numbers_.empty()) {
      const Literal& last = literals_[numbers_.back().literal];
      if (first.set != set_ || literals_[first.literal].offset > last.offset + most_gap || is_complete())
        close();
    }
    set_ = first.set;
    const Hit& hit = next_in_order(hits);
    const SiteNumber number{hit.literal, hit.match.place.constant, hit.match.match, hit.match.variant};
    const auto same = std::find_if(numbers_.begin(), numbers_.end(), [&](const SiteNumber& other) {
      return other.constant == number.constant;
    });
    if (same != numbers_.end()) {
      // A closer match in the place of a loose one belongs to the same site.
      if (number.match < same->match && same->match >= DigitMatch::rounded) {
        numbers_.erase(same);
      } else if (number.match > same->match && number.match >= DigitMatch::rounded) {
        return;
      } else {
        close();
      }
    }
    numbers_.push_back(number);
  }

  void close() {
    if (numbers_.empty()) return;
    Site site{set_, std::move(numbers_)};
    numbers_.clear();
    drop_comments(site);
    add_companions(site);
    site.bits = bits_of(site);
    if (site.bits >= least_bits) sites_.push_back(std::move(site));
  }

  std::vector<Site> take() { return std::move(sites_); }

 private:
  /// Whether all constants are there but those that are looked for near others alone.
  bool is_complete() const {
    const auto& constants = sets_[set_].constants;
    return numbers_.size() >= static_cast<std::size_t>(std::count_if(
                                  constants.begin(), constants.end(), [](const KnownConstant& constant) {
                                    return digits_of(constant.printed).text.size() >= least_digits_alone;
                                  }));
  }

  /// Several constants of a set may have the same digits. Then the number is the next of them in the
  /// published order, or the first that the site does not have yet.
  const Hit& next_in_order(std::span<const Hit> hits) const {
    const DigitMatch closest = hits.front().match.match;
    const auto is_free = [&](const Hit& hit) {
      return hit.match.match == closest &&
             std::none_of(numbers_.begin(), numbers_.end(), [&](const SiteNumber& number) {
               return number.constant == hit.match.place.constant;
             });
    };
    for (const Hit& hit : hits)
      if (is_free(hit) && (numbers_.empty() || hit.match.place.constant > numbers_.back().constant))
        return hit;
    for (const Hit& hit : hits)
      if (is_free(hit)) return hit;
    return hits.front();
  }

  Digits digits_at(std::size_t literal) const { return digits_of(text_, literals_[literal]); }

  /// A number in a comment beside numbers of code is not computed with.
  void drop_comments(Site& site) const {
    const auto is_in_comment = [&](const SiteNumber& number) {
      return literals_[number.literal].is_in_comment;
    };
    if (!std::all_of(site.numbers.begin(), site.numbers.end(), is_in_comment))
      std::erase_if(site.numbers, is_in_comment);
  }

  /// Constants of few digits, such as 0.03, are looked for only near the others.
  void add_companions(Site& site) const {
    constexpr std::size_t most_literals = 6;
    const std::size_t first = site.numbers.front().literal, last = site.numbers.back().literal;
    const std::size_t begin = first - std::min(first, most_literals),
                      end = std::min(literals_.size(), last + most_literals + 1);
    const auto may_be = [&](std::size_t i, const Digits& published) {
      return literals_[i].offset + most_gap > literals_[first].offset &&
             literals_[i].offset < literals_[last].offset + most_gap && !is_taken(site, i) &&
             literals_[i].is_in_comment == literals_[first].is_in_comment && digits_at(i) == published;
    };
    const KnownSet& set = sets_[site.set];
    for (std::size_t c = 0; c < set.constants.size(); ++c) {
      if (has_constant(site, c)) continue;
      const Digits published = digits_of(set.constants[c].printed);
      // In the published order first, and then the nearest: a 1 may stand everywhere.
      const auto place_of = [&](std::size_t i) {
        return std::pair(!keeps_order(site, c, i), i < first ? first - i : i - std::min(i, last));
      };
      std::optional<std::size_t> any;
      for (std::size_t i = begin; i < end; ++i) {
        if (!may_be(i, published)) continue;
        if (!any || place_of(i) < place_of(*any)) any = i;
      }
      if (any) site.numbers.push_back({*any, c});
    }
    std::sort(site.numbers.begin(), site.numbers.end(),
              [](const SiteNumber& a, const SiteNumber& b) { return a.literal < b.literal; });
  }

  /// Whether the constant there leaves those of a site in the published order.
  static bool keeps_order(const Site& site, std::size_t constant, std::size_t literal) {
    return std::all_of(site.numbers.begin(), site.numbers.end(), [&](const SiteNumber& number) {
      return (number.constant < constant) == (number.literal < literal);
    });
  }

  static bool has_constant(const Site& site, std::size_t constant) {
    return std::any_of(site.numbers.begin(), site.numbers.end(),
                       [&](const SiteNumber& number) { return number.constant == constant; });
  }
  static bool is_taken(const Site& site, std::size_t literal) {
    return std::any_of(site.numbers.begin(), site.numbers.end(),
                       [&](const SiteNumber& number) { return number.literal == literal; });
  }

  /// The bits of one number: log2 of 10 for each digit but the first, since small first digits are common.
  double bits_of(const KnownSet& set, const SiteNumber& number) const {
    const double bits_of_a_digit = std::log2(10);
    const KnownConstant& constant = set.constants[number.constant];
    constexpr std::size_t digits_of_a_common_number = 3;
    const std::size_t digits = digits_of(constant.printed).text.size();
    const std::size_t published = constant.is_common ? std::min(digits, digits_of_a_common_number) : digits;
    const auto bits = [&](std::size_t count) { return bits_of_a_digit * (static_cast<double>(count) - 1); };
    if (number.variant) return set.variants[*number.variant].is_borrowed ? 0 : bits(published);
    switch (number.match) {
      case DigitMatch::same:
      case DigitMatch::longer:
      case DigitMatch::float32:
        return bits(published);
      case DigitMatch::rounded:
        return bits(std::min(published, digits_at(number.literal).text.size())) - 1;  // rounded or cut off
      case DigitMatch::shifted:
        return bits(published) - 3;  // some eight other places of the point
      case DigitMatch::edited:
        // A text of n digits has some 20 n neighbours at one edit.
        return bits(published) - std::log2(20 * static_cast<double>(published));
    }
    return 0;
  }

  bool is_next_to(std::size_t literal, bool before, std::string_view brackets) const {
    const Literal& one = literals_[literal];
    const std::string_view rest =
        before ? text_.substr(0, one.offset) : text_.substr(one.offset + one.length);
    const std::string_view blanks = before ? " \t\r\n+-" : " \t\r\n";
    const std::size_t at = before ? rest.find_last_not_of(blanks) : rest.find_first_not_of(blanks);
    return at != std::string_view::npos && brackets.find(rest[at]) != std::string_view::npos;
  }

  /// One order of n! if all n constants stand in the published one, with nothing between. If they are a whole
  /// list, (a, b, c), three more: a row of numbers at a random place is no list.
  double bits_of_order(const Site& site) const {
    const std::size_t count = sets_[site.set].constants.size();
    for (std::size_t i = 0; i < count; ++i) {
      if (site.numbers.size() != count || site.numbers[i].constant != i ||
          site.numbers[i].literal != site.numbers[0].literal + i)
        return 0;
    }
    constexpr double bits_of_a_list = 3;
    const bool is_list = is_next_to(site.numbers.front().literal, true, "([{") &&
                         is_next_to(site.numbers.back().literal, false, ")]}");
    return std::lgamma(static_cast<double>(count) + 1) / std::log(2.0) + (is_list ? bits_of_a_list : 0);
  }

  double bits_of(const Site& site) const {
    double bits = 0;
    for (const SiteNumber& number : site.numbers) bits += bits_of(sets_[site.set], number);
    // Each of them may be any of the numbers there.
    const auto count = static_cast<double>(site.numbers.size());
    const auto there = static_cast<double>(site.numbers.back().literal - site.numbers.front().literal + 1);
    return bits + bits_of_order(site) - count * std::log2(std::max(1.0, there / count));
  }

  std::string_view text_;
  const std::vector<Literal>& literals_;
  const std::vector<KnownSet>& sets_;
  std::size_t set_ = 0;
  std::vector<SiteNumber> numbers_;  ///< of the site that is being collected
  std::vector<Site> sites_;
};

/// The most telling sites first take their numbers. A site that has lost half of its numbers is none.
std::vector<Site> without_shared_numbers(std::vector<Site> sites) {
  std::stable_sort(sites.begin(), sites.end(), [](const Site& a, const Site& b) { return a.bits > b.bits; });
  std::set<std::size_t> taken;
  std::vector<Site> kept;
  for (Site& site : sites) {
    const auto lost = std::count_if(site.numbers.begin(), site.numbers.end(), [&](const SiteNumber& number) {
      return taken.count(number.literal) > 0;
    });
    if (2 * static_cast<std::size_t>(lost) >= site.numbers.size()) continue;
    for (const SiteNumber& number : site.numbers) taken.insert(number.literal);
    kept.push_back(std::move(site));
  }
  std::sort(kept.begin(), kept.end(), [](const Site& a, const Site& b) {
    return a.numbers.front().literal < b.numbers.front().literal;
  });
  return kept;
}

}  // namespace

std::vector<Site> sites_of(std::string_view text, const std::vector<Literal>& literals,
                           const std::vector<KnownSet>& sets, const DigitIndex& index) {
  SiteFinder finder(text, literals, sets);
  const std::vector<Hit> hits = hits_of(text, literals, index);
  for (std::size_t i = 0, end = 0; i < hits.size(); i = end) {
    while (end < hits.size() && hits[end].set == hits[i].set && hits[end].literal == hits[i].literal) ++end;
    finder.add(std::span(hits).subspan(i, end - i));
  }
  finder.close();
  return without_shared_numbers(finder.take());
}

}  // namespace shadefit::lint
