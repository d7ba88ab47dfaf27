#include "lint/scan/sites.hpp"

#include <algorithm>
#include <span>
#include <tuple>
#include <utility>

#include "lint/scan/companions.hpp"
#include "lint/scan/site_bits.hpp"
#include "lint/scan/site_choice.hpp"

namespace shadefit::lint {
namespace {

struct Hit {
  std::size_t set, literal;
  NumberMatch match;
};

std::vector<Hit> hits_of(const std::vector<Literal>& literals, const DigitIndex& index) {
  std::vector<Hit> hits;
  for (std::size_t i = 0; i < literals.size(); ++i) {
    if (literals[i].significant < least_digits_alone) continue;
    for (NumberMatch match : index.find(literals[i].digits)) {
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
      : text_(text), literals_(literals), sets_(sets), companions_(text, literals, sets) {}

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
          !companions_.are_in_one_function(first.literal, numbers_.back().literal) || is_complete())
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
    companions_.add_near(site);
    // A number among several is near a multiple too often.
    constexpr std::size_t two = 2;
    const KnownSet& set = sets_[site.set];
    if (!set.times.empty() && site.numbers.size() < two && set.constants.size() > two) return;
    companions_.add_short(site);
    site.bits = bits_of(text_, literals_, sets_[set_], site);
    if (site.bits >= telling_bits && companions_.add_wrong(site))
      site.bits = bits_of(text_, literals_, sets_[set_], site);
    if (site.bits < least_bits) return;
    if (site.bits < telling_bits) companions_.add_two_slips(site);
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
           literals_[hit.literal].digits == literals_[last].digits;
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

  /// Drops numbers in a comment if others are in code: they are not computed with.
  void drop_comments(Site& site) const {
    const auto is_in_comment = [&](const SiteNumber& number) {
      return literals_[number.literal].is_in_comment;
    };
    if (!std::all_of(site.numbers.begin(), site.numbers.end(), is_in_comment))
      std::erase_if(site.numbers, is_in_comment);
  }

  std::string_view text_;
  const std::vector<Literal>& literals_;
  const std::vector<KnownSet>& sets_;
  Companions companions_;
  std::size_t set_ = 0;
  std::vector<SiteNumber> numbers_;  ///< of the site that is being collected
  std::vector<Site> sites_;
};

}  // namespace

bool is_in_other_units(const Site& site) {
  return std::count_if(site.numbers.begin(), site.numbers.end(),
                       [](const SiteNumber& number) { return number.match == DigitMatch::shifted; }) > 1;
}

std::vector<Site> sites_of(std::string_view text, const std::vector<Literal>& literals,
                           const std::vector<KnownSet>& sets, const DigitIndex& index, const ReadSite& read) {
  const std::vector<Hit> hits = hits_of(literals, index);
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
