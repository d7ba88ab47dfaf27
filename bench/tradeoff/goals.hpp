#pragma once

#include <vector>

#include "bench/tradeoff/trade.hpp"

namespace shadefit::bench {

/// The ratios that were aimed at, from the times in float with the data in the first cache. One that needs a
/// row which is not there has not been reached.
std::vector<Goal> goals_of(const Trade& trade);

}  // namespace shadefit::bench
