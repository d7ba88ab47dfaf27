#include <fmt/format.h>

#include <optional>

#include "app/commands/study_commands.hpp"
#include "app/options/bench_options.hpp"
#include "app/output/draw_figures.hpp"
#include "app/output/output_file.hpp"
#include "app/output/slow_tables.hpp"
#include "app/studies/find_study.hpp"
#include "bench/device/times/device_report.hpp"
#include "bench/device/times/measure_device.hpp"
#include "bench/forms/accuracy.hpp"
#include "bench/studies/measure_study.hpp"
#include "bench/tradeoff/google_json.hpp"
#include "bench/tradeoff/grid_errors.hpp"
#include "bench/tradeoff/measure.hpp"
#include "bench/tradeoff/older_run.hpp"
#include "bench/tradeoff/report.hpp"
#include "fit/support/bounded_file.hpp"
#include "fit/support/known.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/escape.hpp"
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

/// The older run of --compare; read before anything is measured.
std::optional<bench::Medians> older_run(const BenchOptions& options) {
  // A whole bench writes 13 MB.
  constexpr std::uintmax_t most_bytes = 64U << 20;
  using findings::name;
  if (options.format == FindingFormat::github && !options.compare)
    throw UserError(
        fmt::format("--format '{}' needs --compare: without it bench checks nothing", name(options.format)));
  if (!options.compare) return std::nullopt;
  return bench::medians_of(read_bounded(*options.compare, most_bytes), *options.compare);
}

/// What a bench has measured, as text for people.
struct BenchTexts {
  std::string console, markdown;
};

/// A table of each target.
BenchTexts texts_of(const bench::Trade& trade, Table (*table_of)(const bench::Trade&, const std::string&),
                    const Terminal& terminal) {
  BenchTexts texts;
  for (const bench::TimedTarget& target : trade.targets) {
    const Table table = table_of(trade, target.id);
    texts.console += fmt::format("{}\n{}\n", target.title, write_console(table, Precision::report, terminal));
    texts.markdown += fmt::format("### {}\n\n{}", for_markdown(target.title), markdown_block(table));
  }
  return texts;
}

/// The outcome of a bench: its times, and what --compare finds. `err` and `exit_code` are those of the rest.
Outcome bench_outcome(const BenchOptions& options, const bench::Trade& trade,
                      const std::optional<bench::Medians>& older, const BenchTexts& texts,
                      const Outcome& rest) {
  findings::FindingReport report;
  if (older) {
    const auto times = bench::times_in_both(trade, *older);
    if (times.empty())
      throw UserError(
          fmt::format("--compare '{}' has no form of this run with its reference", *options.compare));
    report = bench::slower_forms(times, options.fail_above, *options.compare);
  }
  Outcome outcome = rest;
  if (!passes(report)) outcome.exit_code = 1;
  switch (options.format) {
    case FindingFormat::json:
      outcome.out = google_json(trade, bench::this_occasion());
      break;
    case FindingFormat::markdown:
      outcome.out = (older ? write_findings(report, options.format) + "\n" : "") + texts.markdown;
      break;
    case FindingFormat::text:
      outcome.out = texts.console;
      break;
    default:
      outcome.out = write_findings(report, options.format);
  }
  if (options.format == FindingFormat::text && older && passes(report))
    outcome.out += fmt::format("Compared: {} forms take at most {:g} % longer than in '{}'\n", report.checked,
                               100 * options.fail_above, printable(*options.compare));
  if (options.format == FindingFormat::text || options.format == FindingFormat::json) {
    for (const auto& finding : report.findings)
      outcome.err += fmt::format("shadefit: {}\n", one_line(finding.message));
  }
  return outcome;
}

/// The forms of a study.
Outcome bench_study(const BenchOptions& options, const Checkpoint& checkpoint, const Progress& progress) {
  const auto older = older_run(options);
  const OutputFolder folder(options.out);
  const StudyFile file = named_study(*options.study, study_folders(options.studies));
  const bench::Trade trade = bench::measure_study(file.id, comparisons_of(file, checkpoint),
                                                  options.quick ? bench::quick_plan : bench::full_plan,
                                                  bench::now, bar(checkpoint, progress, "bench"));
  const auto put = folder.prepare(bench::study_bench_files(trade), {}, options.force, checkpoint);
  BenchTexts texts = texts_of(trade, bench::study_times, options.terminal);
  texts.console.pop_back();  // the next line is an empty one too
  texts.console += report_line(options);
  return bench_outcome(options, trade, older, texts, {0, "", "", put});
}

/// The forms of the catalogue, or of a study, on a graphics device.
Outcome bench_on_device(const BenchOptions& options, const Checkpoint& checkpoint, const Progress& progress) {
  const auto older = older_run(options);
  const OutputFolder folder(options.out);
  device::DeviceForms forms;
  if (options.study) {
    const StudyFile file = named_study(*options.study, study_folders(options.studies));
    forms = device::study_forms(file.id, comparisons_of(file, checkpoint));
  } else {
    const forms::Catalogue catalogue = forms::catalogue();
    require_targets(catalogue, options.only);
    forms = device::catalogue_forms(catalogue, options.only);
  }
  const auto plan = options.quick ? device::quick_device_plan : device::full_device_plan;
  device::VulkanDevice for_times(device::choice_for_times(*options.device, plan)),
      for_values(device::choice_for_values(*options.device, forms));
  const bench::Trade trade =
      device::measure_on_device(for_times, for_values, forms, plan, bar(checkpoint, progress, "bench"));
  auto figures = options.no_plots ? std::vector<Figure>{} : bench::bench_figures(trade);
  auto [files, missing, news] = draw_figures(figures, options.out, checkpoint);
  const auto report = device::device_bench_files(trade, figures, bench::this_occasion().date);
  files.insert(files.end(), report.begin(), report.end());
  const auto put = folder.prepare(files, missing, options.force, checkpoint);
  const Table floors = device::floor_table(trade);
  BenchTexts texts = texts_of(trade, device::device_front_table, options.terminal);
  texts.console =
      fmt::format("{}, driver {}\n{}\n{}{}{}", printable(trade.machine.device),
                  printable(trade.machine.driver), write_console(floors, Precision::report, options.terminal),
                  texts.console, news.out, report_line(options));
  texts.markdown = markdown_block(floors) + texts.markdown;
  return bench_outcome(options, trade, older, texts, {news.err.empty() ? 0 : 1, "", news.err, put});
}

}  // namespace

std::vector<File> accuracy_tables(const Checkpoint& checkpoint, const Progress& progress) {
  const auto show = bar(progress, "errors of every form");
  return {{accuracy_file, write_csv(forms::accuracy_table(checkpoint, show), Precision::report)}};
}

Outcome bench_command(const BenchOptions& options, const Checkpoint& checkpoint, const Progress& progress) {
  if (options.list_devices) return list_devices_command(options);
  if (options.probe) return probe_command(options, checkpoint);
  if (options.exhaustive) return exhaustive_command(options, checkpoint, progress);
  if (options.device) return bench_on_device(options, checkpoint, progress);
  if (options.study) return bench_study(options, checkpoint, progress);
  const auto older = older_run(options);
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
                                            bench::now, bar(checkpoint, progress, "bench"));
  auto figures = options.no_plots ? std::vector<Figure>{} : bench::bench_figures(trade);
  auto [files, missing, news] = draw_figures(figures, options.out, checkpoint);
  const auto report = bench::bench_files(trade, accuracy, figures);
  files.insert(files.end(), report.begin(), report.end());
  const auto put = folder.prepare(files, missing, options.force, checkpoint);
  const std::string err = widths_line(options) + news.err;
  const Table goals = bench::goals_table(trade);
  BenchTexts texts = texts_of(trade, bench::front_table, options.terminal);
  texts.console +=
      write_console(goals, Precision::report, options.terminal) + news.out + report_line(options);
  texts.markdown += "### Goals\n\n" + markdown_block(goals);
  return bench_outcome(options, trade, older, texts, {news.err.empty() ? 0 : 1, "", err, put});
}

}  // namespace shadefit
