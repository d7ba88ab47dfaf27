#include "fit/support/known.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// Levenshtein's distance: insertions, deletions and substitutions from a to b.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t above = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0 : 1)});
      diagonal = above;
    }
  }
  return row.back();
}

}  // namespace

void require_known(const std::string& id, const std::vector<std::string>& known, const std::string& what) {
  if (std::find(known.begin(), known.end(), id) != known.end()) return;
  const auto nearest = std::min_element(known.begin(), known.end(), [&](const auto& a, const auto& b) {
    return edit_distance(id, a) < edit_distance(id, b);
  });
  // A suggestion must share at least half of its letters.
  const bool is_near = 2 * edit_distance(id, *nearest) <= nearest->size();
  constexpr std::size_t most_listed = 30;  // in one line
  const auto known_ones = [&] {
    return known.size() <= most_listed ? "it must be one of " + fmt::format("{}", fmt::join(known, ", "))
                                       : std::string("'shadefit list' names them");
  };
  throw UserError("unknown " + what + " '" + id +
                  "': " + (is_near ? "did you mean '" + *nearest + "'?" : known_ones()));
}

}  // namespace shadefit
