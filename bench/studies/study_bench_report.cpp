#include <fmt/format.h>

#include "bench/studies/measure_study.hpp"
#include "bench/tradeoff/tables.hpp"
#include "reports/table/writers.hpp"

namespace shadefit::bench {

std::vector<File> study_bench_files(const Trade& trade) {
  std::string text = fmt::format(
      "# Run time against error\n\n"
      "{}, compiled by {}. Each form is the C code that `emit` writes, in float, one number at a time.\n"
      "The times are medians of {} rounds, each of which visits every form once, on one core, with the data in L1;\n"
      "`spread` is the interquartile range. `x copy`: in times of copying the array.\n"
      "Errors are those of exact arithmetic; times are this machine's, of this day.\n\n",
      trade.machine.cpu, trade.machine.compiler, trade.forms.front().real.size());
  for (const TimedTarget& target : trade.targets)
    text += fmt::format("## {}\n\n{}", target.title, markdown_block(study_times(trade, target.id)));
  text.pop_back();  // sections end in an empty line, the file does not
  return {{"bench.md", text}, {"bench.csv", write_csv(bench_table(trade), Precision::report)}};
}

}  // namespace shadefit::bench
