#include "lint/scan/sites.hpp"

#include <algorithm>
#include <span>
#include <tuple>
#include <utility>

#include "lint/scan/functions.hpp"
#include "lint/scan/lists.hpp"
#include "lint/scan/site_bits.hpp"
#include "lint/scan/site_choice.hpp"

namespace shadefit::lint {
namespace {

/// Constants of one formula are within this many bytes of each other, and in one function.
constexpr std::size_t most_gap = 700;

/// A number of fewer digits is only looked for near the other constants.
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
  // A number may stand for several constants of a set; the closest comes first.
  std::stable_sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
    return std::tuple(a.set, a.literal, a.match.match) < std::tuple(b.set, b.literal, b.match.match);
  });
  return hits;
}

class SiteFinder {
 public:
  SiteFinder(std::string_view text, const std::vector<Literal>& literals, const std::vector<KnownSet>& sets)
      : text_(text), literals_(literals), sets_(sets) {}

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
      const Literal& last = literals_[numbers_.back().literal];
      if (first.set != set_ || literals_[first.literal].offset > last.offset + most_gap ||
          !are_in_one_function(first.literal, numbers_.back().literal) || is_complete())
        close();
    }
    set_ = first.set;
    const Hit& hit = next_in_order(hits);
    const SiteNumber number{hit.literal, hit.match.place.constant, hit.match.match, hit.match.variant};
    const auto same = std::find_if(numbers_.begin(), numbers_.end(), [&](const SiteNumber& other) {
      return other.constant == number.constant;
    });
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
    add_companions(site);
    // A number among several is near a multiple too often.
    constexpr std::size_t two = 2;
    const KnownSet& set = sets_[site.set];
    if (!set.times.empty() && site.numbers.size() < two && set.constants.size() > two) return;
    add_short(site);
    site.bits = bits_of(text_, literals_, sets_[set_], site);
    if (site.bits >= telling_bits && complete(site)) site.bits = bits_of(text_, literals_, sets_[set_], site);
    if (site.bits < least_bits) return;
    if (site.bits < telling_bits) add_two_slips(site);
    sites_.push_back(std::move(site));
  }

  std::vector<Site> take() { return std::move(sites_); }

 private:
  /// Whether all constants are there, except those that are only looked for near others.
  bool is_complete() const {
    const auto& constants = sets_[set_].constants;
    return numbers_.size() >= static_cast<std::size_t>(std::count_if(
                                  constants.begin(), constants.end(), [](const KnownConstant& constant) {
                                    return digits_of(constant.printed).text.size() >= least_digits_alone;
                                  }));
  }

  /// Whether a number only repeats the one before it. A set of one number has a formula each time.
  bool is_next_component(std::span<const Hit> hits) const {
    if (numbers_.empty() || hits.front().set != set_ || sets_[set_].constants.size() == 1) return false;
    const Hit& hit = next_in_order(hits);
    if (hit.match.place.constant != numbers_.back().constant) return false;
    const std::size_t last = numbers_.back().literal;
    return hit.literal == last + 1 && literals_[hit.literal].offset <= literals_[last].offset + most_gap &&
           literals_[hit.literal].is_in_comment == literals_[last].is_in_comment &&
           digits_at(hit.literal) == digits_at(last);
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

  bool are_in_one_function(std::size_t a, std::size_t b) {
    if (!functions_) functions_ = function_begins(text_);
    const auto behind = [&](std::size_t literal) {
      return std::upper_bound(functions_->begin(), functions_->end(), literals_[literal].offset);
    };
    return behind(a) == behind(b);
  }

  Digits digits_at(std::size_t literal) const { return digits_of(text_, literals_[literal]); }

  /// Drops numbers in a comment if others are in code: they are not computed with.
  void drop_comments(Site& site) const {
    const auto is_in_comment = [&](const SiteNumber& number) {
      return literals_[number.literal].is_in_comment;
    };
    if (!std::all_of(site.numbers.begin(), site.numbers.end(), is_in_comment))
      std::erase_if(site.numbers, is_in_comment);
  }

  /// Adds constants of few digits, such as 0.03, near the others.
  void add_companions(Site& site) {
    constexpr std::size_t most_literals = 6;
    const std::size_t first = site.numbers.front().literal, last = site.numbers.back().literal;
    const std::size_t begin = first - std::min(first, most_literals),
                      end = std::min(literals_.size(), last + most_literals + 1);
    const KnownSet& set = sets_[site.set];
    const auto matched = [&](std::size_t i, const Digits& published, std::size_t enough) {
      const Digits found = digits_at(i);
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

  /// Looks for wrong numbers that are no evidence. Only for sites whose numbers are evidence enough. True if
  /// there is one.
  bool complete(Site& site) {
    const bool is_changed = add_rounded_and_edited(site);
    return take_edited_repetitions(site) || is_changed;
  }

  /// Adds missing constants as numbers that were rounded and then mistyped, between or beside the others.
  /// True if there is one.
  bool add_rounded_and_edited(Site& site) {
    const std::size_t count = site.numbers.size();
    const std::size_t first = site.numbers.front().literal, last = site.numbers.back().literal;
    const KnownSet& set = sets_[site.set];
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
      }
    }
    std::sort(site.numbers.begin(), site.numbers.end(),
              [](const SiteNumber& a, const SiteNumber& b) { return a.literal < b.literal; });
    return site.numbers.size() > count;
  }

  /// A constant that the form has at several places may have a wrong digit or exponent at one of them only.
  /// Then that number is the constant. True if there is one.
  bool take_edited_repetitions(Site& site) {
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

  std::vector<std::size_t> missing_of(const Site& site) const {
    std::vector<std::size_t> missing;
    for (std::size_t c = 0; c < sets_[site.set].constants.size(); ++c)
      if (!has_constant(site, c)) missing.push_back(c);
    return missing;
  }

  /// Adds the constant that a list has rounded to too few digits to be looked for alone: 0.072 beside 0.212
  /// and 0.715.
  void add_short(Site& site) const {
    const std::vector<std::size_t> missing = missing_of(site);
    if (missing.size() != 1) return;
    const std::size_t constant = missing.front();
    const std::size_t first = site.numbers.front().literal, last = site.numbers.back().literal;
    const Digits published = digits_of(sets_[site.set].constants[constant].printed);
    for (std::size_t i = first - std::min<std::size_t>(first, 1); i < std::min(literals_.size(), last + 2);
         ++i) {
      const std::size_t begin = std::min(first, i), end = std::max(last, i);
      if (literals_[i].significant >= least_digits_alone || is_taken(site, i) ||
          end - begin != site.numbers.size() ||
          literals_[i].is_in_comment != literals_[first].is_in_comment || !keeps_order(site, constant, i) ||
          !is_shortened(digits_at(i), published) || !have_same_decimals(text_, literals_, begin, end) ||
          !is_whole_list(text_, literals_, begin, end))
        continue;
      insert(site, {i, constant, DigitMatch::rounded});
      return;
    }
  }

  /// Adds the two missing constants of three digits as the nearest numbers with a usual slip: 0.229 for 0.299
  /// and 0.144 for 0.114. They are no evidence: only the expression can show that they belong to the site.
  void add_two_slips(Site& site) {
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

  static void insert(Site& site, const SiteNumber& number) {
    const auto behind = std::find_if(site.numbers.begin(), site.numbers.end(),
                                     [&](const SiteNumber& other) { return other.literal > number.literal; });
    site.numbers.insert(behind, number);
  }

  /// Whether the site's constants stay in the published order with this constant at this literal.
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

  std::string_view text_;
  const std::vector<Literal>& literals_;
  const std::vector<KnownSet>& sets_;
  std::optional<std::vector<std::size_t>> functions_;  ///< where they begin, computed when first needed
  std::size_t set_ = 0;
  std::vector<SiteNumber> numbers_;  ///< of the site that is being collected
  std::vector<Site> sites_;
};

}  // namespace

std::vector<Site> sites_of(std::string_view text, const std::vector<Literal>& literals,
                           const std::vector<KnownSet>& sets, const DigitIndex& index, const ReadSite& read) {
  const std::vector<Hit> hits = hits_of(text, literals, index);
  if (hits.empty()) return {};
  SiteFinder finder(text, literals, sets);
  for (std::size_t i = 0, end = 0; i < hits.size(); i = end) {
    while (end < hits.size() && hits[end].set == hits[i].set && hits[end].literal == hits[i].literal) ++end;
    finder.add(std::span(hits).subspan(i, end - i));
  }
  finder.close();
  return chosen_sites(finder.take(), read);
}

}  // namespace shadefit::lint
