#include "app/shards/ulps_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace shadefit {

Table ulps_table(std::span<const std::uint64_t> ulps, std::uint64_t count, const std::string& numbers) {
  Table table{{"ulps", numbers, "share"}, {}};
  std::size_t last = ulps.size();
  while (last > 1 && ulps[last - 1] == 0) --last;
  for (std::size_t i = 0; i < last; ++i) {
    const std::uint64_t low = i == 0 ? 0 : std::uint64_t{1} << (i - 1), high = (std::uint64_t{1} << i) - 1;
    table.rows.push_back(
        {low >= high ? fmt::to_string(low) : fmt::format("{} .. {}", low, high), static_cast<long>(ulps[i]),
         Number{static_cast<double>(ulps[i]) / static_cast<double>(std::max<std::uint64_t>(count, 1)), 4}});
  }
  return table;
}

}  // namespace shadefit
