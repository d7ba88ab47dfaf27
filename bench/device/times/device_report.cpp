#include "bench/device/times/device_report.hpp"

#include <fmt/format.h>

#include "bench/tradeoff/report.hpp"
#include "reports/table/writers.hpp"

namespace shadefit::device {
namespace {

using bench::measured;

std::string target_section(const bench::Trade& trade, const bench::TimedTarget& target,
                           const std::vector<Figure>& figures) {
  return fmt::format("## {}\n\n{}\n{}{}", target.title, device_advice(trade, target.id),
                     markdown_block(device_front_table(trade, target.id)),
                     bench::figure_block(figures, target));
}

}  // namespace

Table device_front_table(const bench::Trade& trade, const std::string& target) {
  Table table{{"form", "precision", "max abs error", "MADs", "ns", "spread", "MADs in a chain",
               "x faster than the target"},
              {}};
  for (const bench::TimedForm& timed : front_of_target(trade, target)) {
    table.rows.push_back({timed.label, precision_of(timed), measured(timed.max_abs_error),
                          measured(timed.multiply_adds), measured(timed.ns.median),
                          measured(timed.ns.width()), measured(timed.on_device->dependent_multiply_adds),
                          measured(timed.pows)});
  }
  return table;
}

std::string device_advice(const bench::Trade& trade, const std::string& target) {
  std::string text;
  for (const bench::TimedForm& timed : front_of_target(trade, target)) {
    const std::string gain = timed.is_reference ? "; the target itself"
                             : timed.pows
                                 ? fmt::format("; {:.1f} x as fast as the target itself", *timed.pows)
                                 : "";
    text +=
        fmt::format("- An error of {:.2g} allowed: {} in {}, {:.3g} multiply-adds{}.\n", *timed.max_abs_error,
                    timed.label, precision_of(timed), timed.multiply_adds.value(), gain);
  }
  return text.empty() ? "Nothing was measured.\n" : text;
}

Table floor_table(const bench::Trade& trade) {
  Table table{{"what", "precision", "ns", "spread", "ns in a chain"}, {}};
  for (const bench::TimedForm& floor : trade.copies) {
    table.rows.push_back({floor.label, precision_of(floor), measured(floor.ns.median),
                          measured(floor.ns.width()), measured(floor.on_device->dependent_ns)});
  }
  return table;
}

std::vector<File> device_bench_files(const bench::Trade& trade, const std::vector<Figure>& figures,
                                     const std::string& date) {
  std::string text = fmt::format(
      "# Run time against error on a device\n\n"
      "{}, driver {}, on {}; {}; clock: {}. Each form is the GLSL that `emit` writes, in a compute shader. A time is\n"
      "the mean of a long row of evaluations on the whole device, and of such means the median of {} rounds. Each round visits\n"
      "every form once; `spread` is the interquartile range. `MADs`: in the time of a multiply-add in float, four streams a thread;\n"
      "`MADs in a chain`: the same where each evaluation waits for the one before. The loop's own time is subtracted.\n"
      "Errors are the largest of this device, on a grid, against the target in double.\n\n"
      "{}# What to use when\n\n",
      trade.machine.device, trade.machine.driver, trade.machine.cpu, date, trade.machine.clock,
      trade.forms.front().real.size(), markdown_block(floor_table(trade)));
  for (const bench::TimedTarget& target : trade.targets) text += target_section(trade, target, figures);
  text.pop_back();  // sections end in an empty line, the file does not
  return {{"bench.md", text}, {"bench.csv", write_csv(bench_table(trade), Precision::report)}};
}

}  // namespace shadefit::device
