#include "bench/tradeoff/report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reports/io/escape.hpp"
#include "reports/io/writers.hpp"

namespace shadefit::bench {
namespace {

/// A time or an error: three digits, because times are repeatable to about a percent.
Cell measured(const std::optional<double>& value) {
  return value ? Cell(Number{*value, 3}) : Cell{};
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
  Table table{{"target", "form", "constants", "exp2_degree", "precision", "ns_per_element", "spread",
               "max_abs_error", "multiply_adds", "cpu", "compiler", "device", "driver", "clock"}};
  for (const TimedForm& timed : trade.forms)
    table.rows.push_back({timed.target, timed.form, timed.constants, static_cast<long>(timed.exp2_degree),
                          word(name(timed.precision)), measured(timed.ns.median), measured(timed.ns.width),
                          measured(timed.max_abs_error), measured(timed.multiply_adds), machine.cpu,
                          machine.compiler, machine.device, machine.driver, machine.clock});
  return table;
}

Table times_table(const Trade& trade, const std::string& target) {
  Table table{{"form", "precision", "max abs error", "ns", "spread", "MADs", "unbeaten"}};
  for (const TimedForm& timed : shown_forms(trade, target))
    table.rows.push_back({OthersText(timed.label), word(name(timed.precision)), measured(timed.max_abs_error),
                          measured(timed.ns.median), measured(timed.ns.width), measured(timed.multiply_adds),
                          std::string(timed.is_unbeaten ? "yes" : "")});
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
