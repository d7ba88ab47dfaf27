#include <fmt/format.h>

#include "app/commands/commands.hpp"
#include "app/output/output_file.hpp"
#include "fit/stress/fits.hpp"
#include "fit/stress/form_trial.hpp"
#include "reports/io/files.hpp"
#include "reports/io/utf8.hpp"
#include "reports/io/writers.hpp"
#include "reports/rows/stress_tables.hpp"

/// The subcommand `stress`.
namespace shadefit {
namespace {

std::vector<File> tables_as_files(const Table& forms, const Table& fits) {
  return {{forms_stress_file, write_csv(forms, Precision::report)},
          {fits_stress_file, write_csv(fits, Precision::report)}};
}

}  // namespace

std::vector<File> stress_tables(const Checkpoint& checkpoint) {
  return tables_as_files(forms_stress_table(forms_under_stress(checkpoint)),
                         fits_stress_table(fits_under_stress(checkpoint)));
}

Outcome stress_command(const StressOptions& options, const Watched& work) {
  require_writable(options.out);
  const std::vector<FormTrial> trials = forms_under_stress(work.checkpoint);
  const Table forms = forms_stress_table(trials),
              fits = fits_stress_table(fits_under_stress(work.checkpoint));
  const auto put =
      prepare_output(options.out, tables_as_files(forms, fits), {}, options.force, work.checkpoint);
  const std::string err = broken_lines(trials);
  // The columns that say most.
  const Table summary = columns_of(forms, {0, 1, 4, 7, 9, 10, 11, 12, 13, 14});
  return {err.empty() ? 0 : 1,
          write_console(summary, Precision::report, options.terminal) + "\n" +
              write_console(fits, Precision::report, options.terminal) +
              fmt::format("\nTables: {}, {}\n",
                          printable((std::filesystem::path(options.out) / forms_stress_file).string()),
                          fits_stress_file),
          err, put};
}

}  // namespace shadefit
