#include "bench/tradeoff/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "reports/io/escape.hpp"
#include "reports/io/writers.hpp"

namespace shadefit::bench {
namespace {

/// A time or an error: three digits, because times are repeatable to about a percent.
Cell measured(const std::optional<double>& value) {
  return value ? Cell(Number{*value, 3}) : Cell{};
}

using Row = std::vector<std::pair<const char*, Cell>>;

void append(Table& table, const Row& row) {
  table.columns.clear();
  auto& cells = table.rows.emplace_back();
  for (const auto& [column, cell] : row) {
    table.columns.emplace_back(column);
    cells.push_back(cell);
  }
}

std::string how_it_was_measured(const Trade& trade) {
  const Machine& machine = trade.machine;
  if (machine.is_graphics())
    return fmt::format(
        "{}, driver {}, on {}; clock: {}. Each form is the GLSL that `emit` writes, in a compute shader. A time is\n"
        "the mean of a long row of evaluations on the whole device, and of such means the median of {} rounds. Each round visits\n"
        "every form once; `spread` is the interquartile range. `MADs`: in the time of a multiply-add in float. The loop's own time is\n"
        "subtracted, and four evaluations of a thread do not wait for each other.\n"
        "Errors are the largest of this device, on a grid, against the target in double.\n\n",
        machine.device, machine.driver, machine.cpu, machine.clock, trade.rounds);
  return fmt::format(
      "{}, compiled by {}. Each form is the C code that `emit` writes, in float, one number at a time.\n"
      "The times are medians of {} rounds, each of which visits every form once, on one core, with the data in L1;\n"
      "`spread` is the interquartile range. `MADs`: in the time of a multiply-add.\n"
      "Errors are {}. Times are this machine's, of this day.\n\n",
      machine.cpu, machine.compiler, trade.rounds,
      trade.shows_all_sets ? "those of exact arithmetic"
                           : "the largest in float on a grid, against the target in double");
}

}  // namespace

Table bench_table(const Trade& trade) {
  const Machine& machine = trade.machine;
  Table table;
  for (const TimedForm& timed : trade.forms) {
    append(table, {{"target", timed.target},
                   {"form", timed.form},
                   {"constants", timed.constants},
                   {"exp2_degree", static_cast<long>(timed.exp2_degree)},
                   {"precision", word(name(timed.precision))},
                   {"ns_per_element", measured(timed.ns.median)},
                   {"spread", measured(timed.ns.width)},
                   {"max_abs_error", measured(timed.max_abs_error)},
                   {"multiply_adds", measured(timed.multiply_adds)},
                   {"cpu", machine.cpu},
                   {"compiler", machine.compiler},
                   {"device", machine.device},
                   {"driver", machine.driver},
                   {"clock", machine.clock}});
  }
  return table;
}

Table times_table(const Trade& trade, const std::string& target) {
  Table table;
  for (const TimedForm& timed : shown_forms(trade, target))
    append(table, {{"form", OthersText(timed.label)},
                   {"precision", word(name(timed.precision))},
                   {"max abs error", measured(timed.max_abs_error)},
                   {"ns", measured(timed.ns.median)},
                   {"spread", measured(timed.ns.width)},
                   {"MADs", measured(timed.multiply_adds)},
                   {"unbeaten", std::string(timed.is_unbeaten ? "yes" : "")}});
  return table;
}

std::vector<File> bench_files(const Trade& trade, const std::vector<Figure>& figures) {
  std::string text = "# Run time against error\n\n" + how_it_was_measured(trade);
  text += markdown_block(times_table(trade, ""));
  for (const TimedTarget& target : trade.targets) {
    text +=
        fmt::format("## {}\n\n{}", for_markdown(target.title), markdown_block(times_table(trade, target.id)));
    const auto figure = std::ranges::find(figures, "pareto-" + target.id, &Figure::name);
    if (figure != figures.end())
      text += fmt::format("![{0}](plots/{1}.svg)\n\n{0}\n\n", for_markdown(figure->caption), figure->name);
  }
  text.pop_back();  // sections end in an empty line, the file does not
  return {{"bench.md", text}, {"bench.csv", write_csv(bench_table(trade), Precision::report)}};
}

}  // namespace shadefit::bench
