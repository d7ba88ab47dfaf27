#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "app/commands/study_commands.hpp"
#include "app/options/bench_options.hpp"
#include "app/output/draw_figures.hpp"
#include "app/output/output_folder.hpp"
#include "app/output/slow_tables.hpp"
#include "app/studies/find_study.hpp"
#include "bench/forms/accuracy.hpp"
#include "bench/studies/measure_study.hpp"
#include "bench/tradeoff/google_json.hpp"
#include "bench/tradeoff/grid_errors.hpp"
#include "bench/tradeoff/measure.hpp"
#include "bench/tradeoff/report.hpp"
#include "bench/tradeoff/tables.hpp"
#include "fit/support/known.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/utf8.hpp"
#include "reports/table/writers.hpp"

/// The subcommand `bench`, times.
namespace shadefit {

namespace {

void require_targets(const forms::Catalogue& catalogue, const std::vector<std::string>& ids) {
  std::vector<std::string> known;
  for (const forms::Target& target : catalogue.targets) known.emplace_back(target.id);
  for (const std::string& id : ids) require_known(id, known, "target");
}

std::vector<forms::Width> widths_of(const BenchOptions& options) {
  if (!options.width) return forms::widths_here();
  if (*options.width == forms::Width::scalar) return {*options.width};
  return {forms::Width::scalar, *options.width};
}

/// A line that names the missing widths, if the machine lacks some that the forms are compiled for.
std::string widths_line(const BenchOptions& options) {
  const auto here = forms::widths_here();
  if (options.width || here.back() == forms::Width::avx512) return "";
  return fmt::format(
      "shadefit: this machine has no {}: forms were timed up to {}\n",
      forms::name(here.back() == forms::Width::avx2 ? forms::Width::avx512 : forms::Width::avx2),
      forms::name(here.back()));
}

std::string report_line(const BenchOptions& options) {
  return fmt::format("\nReport: {}\n", printable((without_detours(options.out) / "bench.md").string()));
}

/// The forms of a study.
Outcome bench_study(const BenchOptions& options, const Checkpoint& checkpoint, const Progress& progress) {
  const OutputFolder folder(options.out);
  const StudyFile file = named_study(*options.study, study_folders(options.studies));
  const bench::Trade trade = bench::measure_study(
      file.id, comparisons_of(file, checkpoint), options.quick ? bench::quick_plan : bench::full_plan,
      bench::now, [&, show = bar(progress, "bench")](double share) {
        checkpoint();
        show(share);
      });
  const auto put = folder.prepare(bench::study_bench_files(trade), {}, options.force, checkpoint);
  if (options.json) return {0, google_json(trade, bench::this_occasion()), "", put};
  std::string text;
  for (const bench::TimedTarget& target : trade.targets) {
    text +=
        fmt::format("{}{}\n{}", text.empty() ? "" : "\n", target.title,
                    write_console(bench::study_times(trade, target.id), Precision::report, options.terminal));
  }
  return {0, text + report_line(options), "", put};
}

std::string console_text(const bench::Trade& trade, const Terminal& terminal) {
  std::string text;
  for (const bench::TimedTarget& target : trade.targets) {
    text += fmt::format("{}\n{}\n", target.title,
                        write_console(bench::front_table(trade, target.id), Precision::report, terminal));
  }
  return text + write_console(bench::goals_table(trade), Precision::report, terminal);
}

}  // namespace

std::vector<File> accuracy_tables(const Checkpoint& checkpoint, const Progress& progress) {
  const auto show = bar(progress, "errors of every form");
  return {{accuracy_file, write_csv(forms::accuracy_table(checkpoint, show), Precision::report)}};
}

Outcome bench_command(const BenchOptions& options, const std::string& version, const Checkpoint& checkpoint,
                      const Progress& progress) {
  if (options.exhaustive) return exhaustive_command(options, version, checkpoint, progress);
  if (options.study) return bench_study(options, checkpoint, progress);
  const OutputFolder folder(options.out);
  const auto widths = widths_of(options);
  const forms::Catalogue catalogue = forms::catalogue();
  require_targets(catalogue, options.only);
  const auto show = bar(progress, "errors of every form");
  // The accuracy table needs proofs, which take seconds. A quick bench only samples a grid and writes no
  // table.
  const auto accuracy = options.quick ? std::nullopt : std::optional(forms::accuracy_table(checkpoint, show));
  const auto errors =
      accuracy ? bench::form_errors(*accuracy) : bench::grid_errors(catalogue, options.only, checkpoint);
  checkpoint();
  const bench::Trade trade = bench::measure(catalogue, errors,
                                            {.targets = options.only,
                                             .widths = widths,
                                             .plan = options.quick ? bench::quick_plan : bench::full_plan,
                                             .has_little_memory = options.quick},
                                            bench::now, [&, show = bar(progress, "bench")](double share) {
                                              checkpoint();
                                              show(share);
                                            });
  auto figures = options.no_plots ? std::vector<Figure>{} : bench::bench_figures(trade);
  auto [files, missing, news] = draw_figures(figures, options.out, checkpoint);
  const auto report = bench::bench_files(trade, accuracy, figures);
  files.insert(files.end(), report.begin(), report.end());
  const auto put = folder.prepare(files, missing, options.force, checkpoint);
  const std::string err = widths_line(options) + news.err;
  if (options.json) return {news.err.empty() ? 0 : 1, google_json(trade, bench::this_occasion()), err, put};
  return {news.err.empty() ? 0 : 1, console_text(trade, options.terminal) + news.out + report_line(options),
          err, put};
}

}  // namespace shadefit
