#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/tradeoff/trade.hpp"
#include "reports/figures/figure.hpp"
#include "reports/io/files.hpp"

/// A bench as files.
namespace shadefit::bench {

/// bench.md: what to use when, the fronts as tables and pictures, the goals, and how it was measured.
/// `has_table`: whether accuracy.csv stands beside it, which the errors are of; else they are those of a
/// grid.
std::string bench_report(const Trade& trade, const std::vector<Figure>& figures, bool has_table);

/// The figures of all targets that have one.
std::vector<Figure> bench_figures(const Trade& trade);

/// bench.md, bench.csv, and accuracy.csv where there is a table for it.
std::vector<File> bench_files(const Trade& trade, const std::optional<Table>& accuracy,
                              const std::vector<Figure>& figures);

}  // namespace shadefit::bench
