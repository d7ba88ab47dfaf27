#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "reports/table/table.hpp"

namespace shadefit {

/// How many results are how far from the truth. `ulps` counts them: [0] those that are equal, [i] those that
/// are 2^(i-1) to 2^i - 1 ulps away. A share is one of `count` results. `numbers` heads the counts: "floats".
Table ulps_table(std::span<const std::uint64_t> ulps, std::uint64_t count, const std::string& numbers);

}  // namespace shadefit
