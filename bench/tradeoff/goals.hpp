#pragma once

#include <vector>

#include "bench/tradeoff/trade.hpp"

namespace shadefit::bench {

/// The ratios that were aimed at, from the times in float with the data in the first cache. A goal with a
/// missing row counts as not reached.
std::vector<Goal> goals_of(const Trade& trade);

}  // namespace shadefit::bench
