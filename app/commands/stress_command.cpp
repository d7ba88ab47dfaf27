#include <fmt/format.h>

#include "app/commands/commands.hpp"
#include "app/output/output_file.hpp"
#include "app/output/slow_tables.hpp"
#include "fit/stress/starts.hpp"
#include "fit/stress/stress.hpp"
#include "reports/io/files.hpp"
#include "reports/io/utf8.hpp"
#include "reports/rows/stress_tables.hpp"
#include "reports/table/writers.hpp"

/// The subcommand `stress`.
namespace shadefit {
namespace {

struct Stress {
  std::vector<FormTrial> forms;
  std::vector<StartsTrial> fits;
};

Stress under_stress(const Checkpoint& checkpoint, const Progress& progress) {
  Stress stress;
  stress.forms = try_all_forms(stress_inputs, checkpoint, bar(progress, "forms under stress"));
  stress.fits = try_starts(stress_starts, checkpoint, bar(progress, "fits under stress"));
  progress("");
  return stress;
}

}  // namespace

std::vector<File> stress_tables(const Checkpoint& checkpoint, const Progress& progress) {
  const Stress stress = under_stress(checkpoint, progress);
  return stress_files(stress.forms, stress.fits);
}

Outcome stress_command(const StressOptions& options, const Checkpoint& checkpoint, const Progress& progress) {
  const OutputFolder folder(options.out);
  const Stress stress = under_stress(checkpoint, progress);
  const auto put = folder.prepare(stress_files(stress.forms, stress.fits), {}, options.force, checkpoint);
  const std::string err = broken_lines(stress.forms, stress.fits);
  return {err.empty() ? 0 : 1,
          write_console(forms_stress_summary(stress.forms), Precision::report, options.terminal) + "\n" +
              write_console(fits_stress_summary(stress.fits), Precision::report, options.terminal) +
              fmt::format("\nTables: {}, {}\n",
                          printable((without_detours(options.out) / forms_stress_file).string()),
                          fits_stress_file),
          err, put};
}

}  // namespace shadefit
