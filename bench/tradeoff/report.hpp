#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/tradeoff/trade.hpp"
#include "reports/figures/figure.hpp"
#include "reports/io/files.hpp"

/// The files of a bench.
namespace shadefit::bench {

/// bench.md: what to use when, the fronts as tables and pictures, the goals, and how it was measured.
/// `has_table`: whether the errors come from accuracy.csv, written with it; else they come from a grid.
std::string bench_report(const Trade& trade, const std::vector<Figure>& figures, bool has_table);

/// The figures of all targets that have one.
std::vector<Figure> bench_figures(const Trade& trade);

/// bench.md, bench.csv, and accuracy.csv if there is a table for it.
std::vector<File> bench_files(const Trade& trade, const std::optional<Table>& accuracy,
                              const std::vector<Figure>& figures);

}  // namespace shadefit::bench
