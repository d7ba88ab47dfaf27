#pragma once

#include "bench/tradeoff/trade.hpp"
#include "reports/table/table.hpp"

/// Rows of a bench.
namespace shadefit::bench {

/// bench.csv: every form at every width, precision and place, with the machine on each row. Times are never
/// compared with another run's.
Table bench_table(const Trade& trade);

/// The front of a target, for readers: form, error, time, and its multiples.
Table front_table(const Trade& trade, const std::string& target);

/// The goals, and the reached ratios.
Table goals_table(const Trade& trade);

}  // namespace shadefit::bench
