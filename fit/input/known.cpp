#include "fit/input/known.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "fit/support/nearest.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {

void require_known(const std::string& id, const std::vector<std::string>& known, const std::string& what) {
  if (std::find(known.begin(), known.end(), id) != known.end()) return;
  std::vector<std::string> longer;
  for (const std::string& one : known)
    if (one.starts_with(id) && !id.empty()) longer.push_back(one);
  if (const std::size_t count = longer.size(); count > 1) {
    constexpr std::size_t most_suggested = 8;
    longer.resize(std::min(count, most_suggested));
    throw UserError(fmt::format("unknown {} '{}': {} begin so: {}{}", what, id, count,
                                fmt::join(longer, ", "), count > most_suggested ? " .." : ""));
  }
  const auto nearest = longer.empty() ? nearest_name(id, known) : std::optional(longer.front());
  constexpr std::size_t most_listed = 30;  // in one line
  const auto known_ones = [&] {
    return known.size() <= most_listed ? "it must be one of " + fmt::format("{}", fmt::join(known, ", "))
                                       : std::string("'shadefit list' prints all");
  };
  throw UserError("unknown " + what + " '" + id +
                  "': " + (nearest ? "did you mean '" + *nearest + "'?" : known_ones()));
}

}  // namespace shadefit
