#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "app/bench_options.hpp"
#include "app/draw_figures.hpp"
#include "app/output_folder.hpp"
#include "app/slow_tables.hpp"
#include "bench/forms/accuracy.hpp"
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

forms::Width parse_width(const std::string& text) {
  using forms::Width;
  constexpr std::array<std::pair<std::string_view, Width>, 4> known{
      {{"scalar", Width::scalar}, {"sse2", Width::sse2}, {"avx2", Width::avx2}, {"avx512", Width::avx512}}};
  for (const auto& [id, width] : known) {
    if (id != text) continue;
    const auto here = forms::widths_here();
    if (std::find(here.begin(), here.end(), width) != here.end()) return width;
    throw UserError(fmt::format("--width '{}' is not of this machine: its widest registers are {}", text,
                                forms::name(here.back())));
  }
  throw UserError(fmt::format("--width '{}' is unknown: it must be one of scalar, sse2, avx2, avx512", text));
}

namespace {

/// Options of the other kind of bench would be ignored.
void refuse_options_of_exhaustive(const BenchOptions& options) {
  const auto refuse = [](const char* option) {
    throw UserError(fmt::format("{} does not apply: it belongs to --exhaustive", option));
  };
  if (options.constants) refuse("--constants");
  if (options.exp2_degree) refuse("--exp2-degree");
  if (options.shard) refuse("--shard");
  if (options.state) refuse("--state");
  if (options.range) refuse("--range");
  if (!options.merge.empty()) refuse("--merge");
}

void require_targets(const forms::Catalogue& catalogue, const std::vector<std::string>& ids) {
  std::vector<std::string> known;
  for (const forms::Target& target : catalogue.targets) known.emplace_back(target.id);
  for (const std::string& id : ids) require_known(id, known, "target");
}

std::vector<forms::Width> widths_of(const BenchOptions& options) {
  if (!options.width) return forms::widths_here();
  const forms::Width width = parse_width(*options.width);
  if (width == forms::Width::scalar) return {width};
  return {forms::Width::scalar, width};
}

/// A line where the machine has not all of the widths that the forms are compiled for.
std::string widths_line(const BenchOptions& options) {
  const auto here = forms::widths_here();
  if (options.width || here.back() == forms::Width::avx512) return "";
  return fmt::format(
      "shadefit: this machine has no {}: forms were timed up to {}\n",
      forms::name(here.back() == forms::Width::avx2 ? forms::Width::avx512 : forms::Width::avx2),
      forms::name(here.back()));
}

std::string console_text(const bench::Trade& trade) {
  std::string text;
  for (const bench::TimedTarget& target : trade.targets) {
    text += fmt::format("{}\n{}\n", target.title,
                        write_console(bench::front_table(trade, target.id), Precision::report));
  }
  return text + write_console(bench::goals_table(trade), Precision::report);
}

}  // namespace

std::vector<File> accuracy_tables(const Checkpoint& checkpoint, const Progress& progress) {
  checkpoint();
  progress("errors of every form ..");
  return {{accuracy_file, write_csv(forms::accuracy_table(checkpoint), Precision::report)}};
}

Outcome bench_command(const BenchOptions& options, const std::string& version, const Checkpoint& checkpoint,
                      const Progress& progress) {
  if (options.exhaustive) return exhaustive_command(options, version, checkpoint, progress);
  refuse_options_of_exhaustive(options);
  const OutputFolder folder(options.out);
  const auto widths = widths_of(options);
  const forms::Catalogue catalogue = forms::catalogue();
  require_targets(catalogue, options.only);
  checkpoint();
  progress("errors of every form ..");
  // The table of accuracies proves, which takes seconds: a quick bench looks at a grid alone, and writes no
  // table.
  const auto accuracy = options.quick ? std::nullopt : std::optional(forms::accuracy_table(checkpoint));
  const auto errors =
      accuracy ? bench::form_errors(*accuracy) : bench::grid_errors(catalogue, options.only, checkpoint);
  checkpoint();
  const double start = bench::now().real;
  const bench::Trade trade =
      bench::measure(catalogue, errors,
                     {.targets = options.only,
                      .widths = widths,
                      .plan = options.quick ? bench::quick_plan : bench::full_plan,
                      .has_little_memory = options.quick},
                     bench::now, [&](double share) {
                       checkpoint();
                       progress(progress_line("bench", share, bench::now().real - start));
                     });
  auto figures = options.no_plots ? std::vector<Figure>{} : bench::bench_figures(trade);
  auto [files, missing, news] = draw_figures(figures, options.out, checkpoint);
  const auto report = bench::bench_files(trade, accuracy, figures);
  files.insert(files.end(), report.begin(), report.end());
  const auto put = folder.prepare(files, missing, options.force, checkpoint);
  const std::string err = widths_line(options) + news.err;
  if (options.json) return {news.err.empty() ? 0 : 1, google_json(trade, bench::this_occasion()), err, put};
  return {news.err.empty() ? 0 : 1,
          console_text(trade) + news.out +
              fmt::format("\nReport: {}\n", printable((without_detours(options.out) / "bench.md").string())),
          err, put};
}

}  // namespace shadefit
