#pragma once

#include <string>
#include <vector>

#include "bench/trade/trade.hpp"
#include "reports/figure.hpp"
#include "reports/files.hpp"

/// A bench as files.
namespace shadefit::bench {

/// bench.md: what to use when, the fronts as tables and pictures, the goals, and how it was measured.
std::string bench_report(const Trade& trade, const std::vector<Figure>& figures);

/// The figures of all targets that have one.
std::vector<Figure> bench_figures(const Trade& trade);

/// bench.csv, accuracy.csv, bench.md.
std::vector<File> bench_files(const Trade& trade, const Table& accuracy, const std::vector<Figure>& figures);

/// The names of files that a bench without figures leaves out; `written` holds what it has.
std::vector<std::string> missing_pictures(const std::vector<TimedTarget>& all_targets,
                                          const std::vector<File>& written);

}  // namespace shadefit::bench
