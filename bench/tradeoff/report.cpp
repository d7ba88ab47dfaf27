#include "bench/tradeoff/report.hpp"

#include <fmt/format.h>

#include "reports/io/escape.hpp"
#include "reports/io/joined.hpp"
#include "reports/table/writers.hpp"

namespace shadefit::bench {
namespace {

std::string target_section(const Trade& trade, const TimedTarget& target,
                           const std::vector<Figure>& figures) {
  std::string text = fmt::format("## {}\n\n{}\n", target.title, advice(trade, target.id));
  const Table front = front_table(trade, target.id);
  if (!front.rows.empty()) text += markdown_block(front);
  return text + figure_block(figures, target);
}

}  // namespace

std::string figure_block(const std::vector<Figure>& figures, const TimedTarget& target) {
  for (const Figure& figure : figures) {
    if (figure.name == "pareto-" + target.id)
      return fmt::format("![{0}](plots/{1}.svg)\n\n{0}\n\n", for_markdown(figure.caption), figure.name);
  }
  return "";
}

std::string bench_report(const Trade& trade, const std::vector<Figure>& figures, bool has_table) {
  const Machine& machine = trade.machine;
  std::string text = fmt::format(
      "# Run time against error\n\n"
      "{}, compiled by {}; widths: {}. Medians of {} rounds, each of which visits every form once, on one core; "
      "`spread` is the interquartile range. `x copy`: in times of copying the same array in the same registers; `x faster than "
      "pow`: than the scalar loop over the library's own functions in the same precision. Errors are {}; times are "
      "this machine's, of this day. Each form stands at its fastest width, its data in L1.\n\n",
      machine.cpu, machine.compiler, joined(trade.widths, ", ", forms::name),
      trade.forms.empty() ? 0 : trade.forms.front().real.size(),
      has_table ? "those of `accuracy.csv`, which is the same everywhere" : "the largest on a grid");
  text += "# What to use when\n\n";
  for (const TimedTarget& target : trade.targets) text += target_section(trade, target, figures);
  if (!trade.goals.empty()) {
    text += "# Goals\n\nRatios within this run, all in float with the data in L1.\n\n" +
            markdown_block(goals_table(trade));
  }
  text.pop_back();  // sections end in an empty line, the file does not
  return text;
}

std::vector<Figure> bench_figures(const Trade& trade) {
  std::vector<Figure> figures;
  for (const TimedTarget& target : trade.targets) {
    if (has_pareto_figure(trade, target)) figures.push_back(pareto_figure(trade, target));
  }
  return figures;
}

std::vector<File> bench_files(const Trade& trade, const std::optional<Table>& accuracy,
                              const std::vector<Figure>& figures) {
  std::vector<File> files{{"bench.md", bench_report(trade, figures, accuracy.has_value())},
                          {"bench.csv", write_csv(bench_table(trade), Precision::report)}};
  if (accuracy) files.push_back({"accuracy.csv", write_csv(*accuracy, Precision::report)});
  return files;
}

}  // namespace shadefit::bench
