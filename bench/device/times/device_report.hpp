#pragma once

#include <string>
#include <vector>

#include "bench/tradeoff/trade.hpp"
#include "reports/figures/figure.hpp"
#include "reports/io/files.hpp"
#include "reports/table/table.hpp"

/// The times of a device in words and tables.
namespace shadefit::device {

/// The forms that no other beats in time and error, the fastest first. In half those that no form in float
/// beats.
Table device_front_table(const bench::Trade& trade, const std::string& target);

/// One line of a list for each form on the front of a target: what to use for which error.
std::string device_advice(const bench::Trade& trade, const std::string& target);

/// The multiply-add, the copy and the empty dispatch.
Table floor_table(const bench::Trade& trade);

/// bench.md and bench.csv. `date` is ISO 8601.
std::vector<File> device_bench_files(const bench::Trade& trade, const std::vector<Figure>& figures,
                                     const std::string& date);

}  // namespace shadefit::device
