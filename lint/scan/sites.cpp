#include "lint/scan/sites.hpp"

#include <algorithm>
#include <iterator>
#include <span>
#include <tuple>
#include <utility>

#include "lint/scan/lists.hpp"
#include "lint/scan/notation.hpp"

namespace shadefit::lint {
namespace {

/// Constants of one formula are within this many bytes of each other, and in one function.
constexpr std::size_t most_gap = 700;

/// A number of fewer digits is only looked for near the other constants.
constexpr std::size_t least_digits_alone = 3;

/// Numbers of few digits are looked for at most so many literals away.
constexpr std::size_t most_literals = 6;

struct Hit {
  std::size_t literal;
  NumberMatch match;
  std::size_t set() const { return match.place.set; }
};

std::vector<Hit> hits_of(const ScannedText& text, const DigitIndex& index) {
  const std::span<const Literal> literals = text.literals;
  std::vector<Hit> hits;
  for (std::size_t i = 0; i < literals.size(); ++i) {
    if (literals[i].significant < least_digits_alone) continue;
    for (NumberMatch match : index.find(literals[i].digits)) {
      // With such a factor the decimal point says nothing.
      if (match.match == DigitMatch::shifted &&
          is_before_power_of_ten(text.text, literals[i].offset + literals[i].length))
        match.match = DigitMatch::same;
      hits.push_back({i, match});
    }
  }
  // A number may stand for several constants of a set; the closest comes first.
  std::ranges::stable_sort(
      hits, {}, [](const Hit& hit) { return std::tuple(hit.set(), hit.literal, hit.match.match); });
  return hits;
}

bool is_taken(const Site& site, std::size_t literal) {
  return std::ranges::find(site.numbers, literal, &SiteNumber::literal) != site.numbers.end();
}

/// Adds a number, by its place.
void insert(Site& site, const SiteNumber& number) {
  site.numbers.insert(std::ranges::upper_bound(site.numbers, number.literal, {}, &SiteNumber::literal),
                      number);
}

/// Whether the site's constants stay in the published order with this constant at this literal.
bool keeps_order(const Site& site, std::size_t constant, std::size_t literal) {
  return std::ranges::all_of(site.numbers, [&](const SiteNumber& number) {
    return (number.constant < constant) == (number.literal < literal);
  });
}

/// How many literals a literal is away from the site.
std::size_t distance_to(const Site& site, std::size_t literal) {
  const std::size_t first = site.numbers.front().literal, last = site.numbers.back().literal;
  return literal < first ? first - literal : literal - std::min(literal, last);
}

class SiteFinder {
 public:
  SiteFinder(const ScannedText& text, const std::vector<KnownSet>& sets) : text_(text), sets_(sets) {}

  /// Takes the hits of one number and one set, in order. A repeated constant begins the next site, and so
  /// does every number after a complete site: the next copy of the formula may be the wrong one. The
  /// components of a vector are one number: vec3(0.055, 0.055, 0.055).
  void add(std::span<const Hit> hits) {
    const Hit& first = hits.front();
    if (is_next_component(hits)) {
      numbers_.back().literal = first.literal;
      ++numbers_.back().repeats;
      return;
    }
    if (!numbers_.empty()) {
      const std::size_t last = numbers_.back().literal;
      if (first.set() != set_ || at(first.literal).offset > at(last).offset + most_gap ||
          !are_in_one_function(first.literal, last) || is_complete())
        close();
    }
    set_ = first.set();
    const Hit& hit = next_in_order(hits);
    const SiteNumber number{hit.literal, hit.match.place.constant, hit.match.match, hit.match.variant};
    const auto same = std::ranges::find(numbers_, number.constant, &SiteNumber::constant);
    if (same != numbers_.end()) {
      // A closer match that replaces a loose one belongs to the same site.
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
    add_near(site);
    const KnownSet& set = sets_[site.set];
    add_in_list(site, &SiteFinder::shortened);
    site.bits = bits_of(text_, set, site);
    if (site.bits < telling_bits) {
      Site whole = site;
      add_in_list(whole, &SiteFinder::slipped);
      whole.bits = bits_of(text_, set, whole);
      if (whole.bits >= telling_bits) site = std::move(whole);
    }
    if (site.bits < least_bits) return;
    if (site.bits < telling_bits) add_two_slips(site);
    sites_.push_back(std::move(site));
  }

  std::vector<Site> take() { return std::move(sites_); }

 private:
  const Literal& at(std::size_t literal) const { return text_.literals[literal]; }
  const KnownSet& set_of(const Site& site) const { return sets_[site.set]; }
  Digits published(const Site& site, std::size_t constant) const {
    return digits_of(set_of(site).constants[constant].printed);
  }

  /// Whether all constants are there, except those that are only looked for near others.
  bool is_complete() const {
    const auto is_looked_for = [](const KnownConstant& constant) {
      return digits_of(constant.printed).text.size() >= least_digits_alone;
    };
    return std::ssize(numbers_) >= std::ranges::count_if(sets_[set_].constants, is_looked_for);
  }

  /// Whether a number only repeats the one before it. A set of one number has a formula each time.
  bool is_next_component(std::span<const Hit> hits) const {
    if (numbers_.empty() || hits.front().set() != set_ || sets_[set_].constants.size() == 1) return false;
    const Hit& hit = next_in_order(hits);
    if (hit.match.place.constant != numbers_.back().constant) return false;
    const Literal &here = at(hit.literal), &last = at(numbers_.back().literal);
    return hit.literal == numbers_.back().literal + 1 && here.offset <= last.offset + most_gap &&
           here.is_in_comment == last.is_in_comment && here.digits == last.digits;
  }

  /// Several constants of a set may have the same digits. Then the number is the next of them in the
  /// published order, or the first that the site does not have yet.
  const Hit& next_in_order(std::span<const Hit> hits) const {
    const DigitMatch closest = hits.front().match.match;
    const auto is_free = [&](const Hit& hit) {
      return hit.match.match == closest &&
             std::ranges::find(numbers_, hit.match.place.constant, &SiteNumber::constant) == numbers_.end();
    };
    for (const Hit& hit : hits)
      if (is_free(hit) && (numbers_.empty() || hit.match.place.constant > numbers_.back().constant))
        return hit;
    const auto free = std::ranges::find_if(hits, is_free);
    return free == hits.end() ? hits.front() : *free;
  }

  /// Drops numbers in a comment if others are in code: they are not computed with.
  void drop_comments(Site& site) const {
    const auto is_in_comment = [&](const SiteNumber& number) { return at(number.literal).is_in_comment; };
    if (!std::ranges::all_of(site.numbers, is_in_comment)) std::erase_if(site.numbers, is_in_comment);
  }

  bool are_in_one_function(std::size_t a, std::size_t b) {
    if (!functions_) functions_ = function_begins(text_.text);
    const auto behind = [&](std::size_t literal) {
      return std::ranges::upper_bound(*functions_, at(literal).offset);
    };
    return behind(a) == behind(b);
  }
  bool is_in_function_of(const Site& site, std::size_t literal) {
    return are_in_one_function(literal, site.numbers.front().literal);
  }

  /// The literals at most this far from a site that are none of its numbers and, like those, in a comment or
  /// in code.
  std::vector<std::size_t> free_near(const Site& site, std::size_t most) const {
    const std::size_t first = site.numbers.front().literal, last = site.numbers.back().literal;
    std::vector<std::size_t> free;
    for (std::size_t i = first - std::min(first, most); i < std::min(text_.literals.size(), last + most + 1);
         ++i)
      if (!is_taken(site, i) && at(i).is_in_comment == at(first).is_in_comment) free.push_back(i);
    return free;
  }

  /// Adds constants of few digits, such as 0.03, near the others.
  void add_near(Site& site) {
    const Site given = site;
    const Literal &first = at(site.numbers.front().literal), &last = at(site.numbers.back().literal);
    std::vector<std::size_t> near = free_near(site, most_literals);
    std::erase_if(near, [&](std::size_t i) {
      return at(i).offset + most_gap <= first.offset || at(i).offset >= last.offset + most_gap;
    });
    for (const std::size_t c : missing_constants(set_of(site), site)) {
      const Digits digits = published(site, c);
      // First by the published order, then by distance: a 1 may be anywhere.
      const auto place_of = [&](std::size_t i) {
        return std::pair(!keeps_order(site, c, i), distance_to(given, i));
      };
      std::optional<std::size_t> best;
      for (const std::size_t i : near) {
        if (at(i).digits != digits || is_taken(site, i) || !is_in_function_of(given, i)) continue;
        if (!best || place_of(i) < place_of(*best)) best = i;
      }
      if (best) insert(site, {*best, c});
    }
  }

  /// A number of a list that has too few digits to be looked for alone, as 0.072 beside 0.212 and 0.715.
  static std::optional<DigitMatch> shortened(const Literal& literal, const Digits& published) {
    if (literal.significant >= least_digits_alone || !is_shortened(literal.digits, published))
      return std::nullopt;
    return DigitMatch::rounded;
  }

  /// A number of a list that has too few digits to be looked for with an edit: 0.0772 beside 0.2126 and
  /// 0.7152.
  static std::optional<DigitMatch> slipped(const Literal& literal, const Digits& published) {
    if (published.text.size() != least_digits_alone || !is_edited(literal.digits, published))
      return std::nullopt;
    return is_usual_slip(literal.digits, published) ? DigitMatch::usual_slip : DigitMatch::edited;
  }

  /// Adds the only missing constant, if it is in a list with the others, in the published order.
  void add_in_list(Site& site, std::optional<DigitMatch> (*match_of)(const Literal&, const Digits&)) const {
    const std::vector<std::size_t> missing = missing_constants(set_of(site), site);
    if (missing.size() != 1) return;
    const std::size_t constant = missing.front();
    const std::size_t first = site.numbers.front().literal, last = site.numbers.back().literal;
    for (const std::size_t i : free_near(site, 1)) {
      const std::size_t begin = std::min(first, i), end = std::max(last, i);
      const auto match = match_of(at(i), published(site, constant));
      if (!match || end - begin != site.numbers.size() || !keeps_order(site, constant, i) ||
          !have_same_decimals(text_, begin, end) || !is_whole_list(text_, begin, end))
        continue;
      return insert(site, {i, constant, *match});
    }
  }

  /// Adds the two missing constants of three digits as the nearest numbers with a usual slip: 0.229 for 0.299
  /// and 0.144 for 0.114. They are no evidence: only the expression can show that they belong to the site.
  void add_two_slips(Site& site) {
    std::vector<std::size_t> missing = missing_constants(set_of(site), site);
    std::erase_if(missing, [&](std::size_t c) { return set_of(site).constants[c].is_common; });
    if (missing.size() != 2) return;
    Site whole = site;
    for (const std::size_t constant : missing) {
      const Digits digits = published(site, constant);
      if (digits.text.size() != least_digits_alone) return;
      std::optional<std::size_t> nearest;
      for (const std::size_t i : free_near(site, most_literals)) {
        if (is_taken(whole, i) || !is_in_function_of(site, i) || !is_usual_slip(at(i).digits, digits))
          continue;
        if (!nearest || distance_to(site, i) < distance_to(site, *nearest)) nearest = i;
      }
      if (!nearest) return;
      insert(whole, {*nearest, constant, DigitMatch::edited});
    }
    site = std::move(whole);
  }

  const ScannedText& text_;
  const std::vector<KnownSet>& sets_;
  std::optional<std::vector<std::size_t>> functions_;  ///< where they begin, computed when first needed
  std::size_t set_ = 0;
  std::vector<SiteNumber> numbers_;  ///< of the site that is being collected
  std::vector<Site> sites_;
};

}  // namespace

bool is_in_other_units(const Site& site) {
  return std::ranges::count(site.numbers, DigitMatch::shifted, &SiteNumber::match) > 1;
}

std::vector<std::size_t> missing_constants(const KnownSet& set, const Site& site) {
  std::vector<std::size_t> missing;
  for (std::size_t c = 0; c < set.constants.size(); ++c)
    if (std::ranges::find(site.numbers, c, &SiteNumber::constant) == site.numbers.end()) missing.push_back(c);
  return missing;
}

std::vector<Site> sites_of(const ScannedText& text, const std::vector<KnownSet>& sets,
                           const DigitIndex& index, const ReadSite& read) {
  const std::vector<Hit> hits = hits_of(text, index);
  if (hits.empty()) return {};
  SiteFinder finder(text, sets);
  for (std::size_t i = 0, end = 0; i < hits.size(); i = end) {
    while (end < hits.size() && hits[end].set() == hits[i].set() && hits[end].literal == hits[i].literal)
      ++end;
    finder.add(std::span(hits).subspan(i, end - i));
  }
  finder.close();
  return chosen_sites(finder.take(), read);
}

}  // namespace shadefit::lint
