#include <fmt/format.h>

#include <string>
#include <vector>

#include "app/commands/commands.hpp"
#include "app/device/device_commands.hpp"
#include "app/output/draw_figures.hpp"
#include "app/output/output_file.hpp"
#include "app/studies/find_study.hpp"
#include "bench/tradeoff/measure.hpp"
#include "bench/tradeoff/report.hpp"
#include "bench/tradeoff/timed_forms.hpp"
#include "fit/input/known.hpp"
#include "reports/io/utf8.hpp"
#include "reports/io/writers.hpp"

/// The subcommand `bench`.
namespace shadefit {
namespace {

/// The forms of the catalogue, or of a study, in the language of what times them.
bench::Trade forms_to_time(const BenchOptions& options, const Checkpoint& checkpoint) {
  const Language language = options.device ? Language::glsl : Language::c;
  if (options.study) {
    const StudyFile file = named_study(*options.study, study_folders(options.studies));
    return bench::study_forms(file.id, comparisons_of(file, {checkpoint, unwatched}), language);
  }
  const std::vector<forms::Target> catalogue = forms::catalogue();
  std::vector<std::string> known;
  for (const forms::Target& target : catalogue) {
    if (!bench::is_of_several_lights(target)) known.emplace_back(target.id);
  }
  for (const std::string& id : options.only) require_known(id, known, "target");
  return bench::catalogue_forms(catalogue, options.only,
                                options.device ? bench::Exp2Kinds::library : bench::Exp2Kinds::polynomials);
}

}  // namespace

Outcome bench_command(const BenchOptions& options, const Watched& work) {
  if (options.list_devices) return list_devices_command(options);
  if (options.exhaustive) return exhaustive_command(options, work);
  require_writable(options.out);
  const auto forms = [&] { return forms_to_time(options, work.checkpoint); };
  const bench::TimingPlan& plan = options.quick ? bench::quick_plan : bench::full_plan;
  const bench::Trade trade = options.device ? trade_on_device(options, forms, work)
                                            : bench::measure(forms(), plan, bar(work, "bench"));
  auto figures = options.no_plots ? std::vector<Figure>{} : bench::bench_figures(trade);
  auto [files, missing, said, failed] = draw_figures(figures, options.out, work.checkpoint);
  const auto report = bench::bench_files(trade, figures);
  files.insert(files.end(), report.begin(), report.end());
  std::string out;
  if (trade.machine.is_graphics())
    out = fmt::format("{}, driver {}\n", printable(trade.machine.device), printable(trade.machine.driver));
  out += write_console(bench::times_table(trade, ""), Precision::report, options.terminal) + "\n";
  for (const bench::TimedTarget& target : trade.targets)
    out +=
        fmt::format("{}\n{}\n", target.title,
                    write_console(bench::times_table(trade, target.id), Precision::report, options.terminal));
  out.pop_back();  // the next line is an empty one too
  out += said + "\nReport: " + printable((std::filesystem::path(options.out) / "bench.md").string()) + "\n";
  return {failed.empty() ? 0 : 1, out, failed,
          prepare_output(options.out, files, missing, options.force, work.checkpoint)};
}

}  // namespace shadefit
