#pragma once

#include <string>
#include <vector>

#include "bench/tradeoff/trade.hpp"
#include "reports/figures/figure.hpp"
#include "reports/io/files.hpp"
#include "reports/table/table.hpp"

/// The times of a device in words and tables.
namespace shadefit::device {

/// The forms that no other form beats in both time and error, the fastest first. A form in half is listed
/// only if no form in float beats it.
Table device_front_table(const bench::Trade& trade, const std::string& target);

/// What to use for which error: a list with one line for each form on the front of a target.
std::string device_advice(const bench::Trade& trade, const std::string& target);

/// The times of a multiply-add, of the copy and of the empty dispatch.
Table floor_table(const bench::Trade& trade);

/// bench.md and bench.csv. `date` is ISO 8601.
std::vector<File> device_bench_files(const bench::Trade& trade, const std::vector<Figure>& figures,
                                     const std::string& date);

}  // namespace shadefit::device
