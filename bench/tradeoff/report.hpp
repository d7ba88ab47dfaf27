#pragma once

#include <string>
#include <vector>

#include "bench/tradeoff/trade.hpp"
#include "reports/figures/plot_script.hpp"
#include "reports/io/files.hpp"
#include "reports/io/table.hpp"

/// A bench as tables, pictures and files.
namespace shadefit::bench {

/// bench.csv: every form with every set of constants, with the machine on each row. Times are never compared
/// with another run's.
Table bench_table(const Trade& trade);

/// The forms of a target, the fastest first, with a mark on those that no other beats in time and error.
Table times_table(const Trade& trade, const std::string& target);

/// "pareto-TARGET" of each target: error against time of its forms in float, both axes logarithmic. A line
/// joins the forms that no other beats; these have their names. A target without an error has no picture.
std::vector<Figure> bench_figures(const Trade& trade);

/// bench.md and bench.csv.
std::vector<File> bench_files(const Trade& trade, const std::vector<Figure>& figures);

}  // namespace shadefit::bench
