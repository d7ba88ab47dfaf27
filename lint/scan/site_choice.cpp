#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "lint/scan/sites.hpp"

namespace shadefit::lint {
namespace {

/// Gives each number to one site, the most telling sites first.
class SiteChoice {
 public:
  SiteChoice(std::vector<Site> sites, const ReadSite& read)
      : sites_(std::move(sites)), read_(read), readings_(sites_.size()), is_done_(sites_.size()) {
    std::ranges::stable_sort(sites_, std::ranges::greater(), &Site::bits);
    for (std::size_t i = 0; i < sites_.size(); ++i)
      for (const SiteNumber& number : sites_[i].numbers) at_.emplace_back(number.literal, i);
    std::ranges::sort(at_);
  }

  /// The kept sites, by their places.
  std::vector<Site> choose() {
    for (std::size_t i = 0; i < sites_.size(); ++i) {
      if (!is_done_[i]) keep(better_read(i));
      if (!is_done_[i]) keep(i);
    }
    std::ranges::sort(kept_, {}, [](const Site& site) { return site.numbers.front().literal; });
    return std::move(kept_);
  }

 private:
  /// Keeps a site unless it has lost half of its numbers.
  void keep(std::size_t i) {
    is_done_[i] = true;
    Site& site = sites_[i];
    if (is_half_taken(site)) return;
    for (const SiteNumber& number : site.numbers) taken_.insert(number.literal);
    kept_.push_back(std::move(site));
  }

  /// Whether other sites have half of its numbers.
  bool is_half_taken(const Site& site) const {
    const auto is_taken = [&](const SiteNumber& number) { return taken_.contains(number.literal); };
    return 2 * std::ranges::count_if(site.numbers, is_taken) >= std::ssize(site.numbers);
  }

  const Reading& reading(std::size_t i) {
    if (!readings_[i]) readings_[i] = read_(sites_[i]);
    return *readings_[i];
  }

  /// Of the sites that have most of these numbers, the one whose form is read best.
  std::size_t better_read(std::size_t i) {
    if (is_half_taken(sites_[i])) return i;
    std::size_t best = i;
    for (const std::size_t other : rivals_of(i)) {
      if (reading(best).part == Reading::Part::form) break;
      if (reading(other).part > reading(best).part && reading(other).constants >= sites_[i].numbers.size())
        best = other;
    }
    return best;
  }

  /// The less telling sites that have most of the numbers of a site.
  std::vector<std::size_t> rivals_of(std::size_t i) const {
    std::map<std::size_t, std::size_t> shared;
    for (const SiteNumber& number : sites_[i].numbers) {
      // The sites after this one in the order of `sites_`.
      auto other = std::upper_bound(at_.begin(), at_.end(), std::pair(number.literal, i));
      for (; other != at_.end() && other->first == number.literal; ++other)
        if (!is_done_[other->second]) ++shared[other->second];
    }
    std::vector<std::size_t> rivals;
    for (const auto& [other, count] : shared)
      if (2 * count > sites_[i].numbers.size()) rivals.push_back(other);
    return rivals;
  }

  std::vector<Site> sites_, kept_;
  const ReadSite& read_;
  std::vector<std::optional<Reading>> readings_;
  std::vector<bool> is_done_;
  std::vector<std::pair<std::size_t, std::size_t>> at_;  ///< each literal with a site that has it, sorted
  std::set<std::size_t> taken_;                          ///< literals
};

}  // namespace

std::vector<Site> chosen_sites(std::vector<Site> sites, const ReadSite& read) {
  return SiteChoice(std::move(sites), read).choose();
}

}  // namespace shadefit::lint
