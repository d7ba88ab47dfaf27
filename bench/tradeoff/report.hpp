#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/tradeoff/trade.hpp"
#include "reports/figures/figure.hpp"
#include "reports/io/files.hpp"
#include "reports/table/table.hpp"

/// A bench in words, tables, figures and files.
namespace shadefit::bench {

/// A time or an error: three digits, because times are repeatable to about a percent.
Cell measured(double value);
Cell measured(const std::optional<double>& value);

/// bench.csv: every form at every width, precision and place, with the machine on each row. Times are never
/// compared with another run's.
Table bench_table(const Trade& trade);

/// The front of a target, for readers: form, error, time, and its multiples.
Table front_table(const Trade& trade, const std::string& target);

/// The goals, and the reached ratios.
Table goals_table(const Trade& trade);

/// One line of a list for each form on the front of a target, from the least exact on: "Up to an error of E
/// ..".
std::string advice(const Trade& trade, const std::string& target);

/// "pareto-TARGET": error against time of the forms of a target in float, both axes logarithmic, data in the
/// first cache, each form at its fastest width. A line joins the front. Every mark has its name. Needs a form
/// with an error.
Figure pareto_figure(const Trade& trade, const TimedTarget& target);

/// Whether a target has the data for its figure.
bool has_pareto_figure(const Trade& trade, const TimedTarget& target);

/// bench.md: what to use when, the fronts as tables and pictures, the goals, and how it was measured.
/// `has_table`: whether the errors come from accuracy.csv, written with it; else they come from a grid.
std::string bench_report(const Trade& trade, const std::vector<Figure>& figures, bool has_table);

/// The figure of a target with its caption, in Markdown; empty if it has none.
std::string figure_block(const std::vector<Figure>& figures, const TimedTarget& target);

/// The figures of all targets that have one.
std::vector<Figure> bench_figures(const Trade& trade);

/// bench.md, bench.csv, and accuracy.csv if there is a table for it.
std::vector<File> bench_files(const Trade& trade, const std::optional<Table>& accuracy,
                              const std::vector<Figure>& figures);

}  // namespace shadefit::bench
