#include <fmt/format.h>

#include <bit>

#include "app/commands/commands.hpp"
#include "app/device/device_commands.hpp"
#include "app/output/output_file.hpp"
#include "fit/input/known.hpp"
#include "fit/support/hex_float.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/utf8.hpp"
#include "reports/io/writers.hpp"

/// `bench --exhaustive`.
namespace shadefit {
namespace {

/// The forms that the option means, with their constants.
std::vector<bench::SweptForm> swept_forms(const std::vector<forms::Target>& catalogue,
                                          const BenchOptions& options) {
  const std::string& id = *options.exhaustive;
  const bool is_all = id == "all";
  if (is_all && options.constants)
    throw UserError("--exhaustive 'all' does not apply with --constants: it takes every set of every form");
  std::vector<bench::SweptForm> all;
  std::vector<std::string> known, sets;
  for (const forms::Target& target : catalogue) {
    const bool is_of_cosine = target.arguments == forms::Arguments::cosine;
    for (const forms::FormEntry& form : target.forms) {
      if (is_of_cosine) known.emplace_back(form.id);
      if (form.id != id && !(is_all && is_of_cosine)) continue;
      if (!is_of_cosine)
        throw UserError(
            fmt::format("--exhaustive '{}' is not a form of one cosine: it reads {} of each element", id,
                        target.arguments == forms::Arguments::cosine_and_code ? "a gloss too" : "a normal"));
      for (const forms::Constants& constants : form.constants) {
        sets.push_back(constants.id);
        if (!options.constants || constants.id == *options.constants)
          all.push_back({&form, &target, &constants});
      }
      if (!is_all && !options.constants) all.resize(1);  // its first set
    }
  }
  if (!is_all) require_known(id, known, "form of one cosine");
  if (all.empty())
    throw UserError(fmt::format("--constants '{}' is not a set of {}: it must be one of {}",
                                *options.constants, id, fmt::join(sets, ", ")));
  return all;
}

std::string hex_place(std::uint32_t at) {
  return hex_text(static_cast<double>(std::bit_cast<float>(at)));
}

void append_row(Table& table, const bench::SweptForm& swept, const bench::FloatErrors& found) {
  table.rows.push_back({std::string(swept.form->id), swept.constants->id, static_cast<long>(found.count()),
                        Number{static_cast<double>(found.max_abs_error), 6},
                        hex_place(found.max_abs_error_at), static_cast<long>(found.max_ulps),
                        hex_place(found.max_ulps_at), static_cast<long>(found.nans),
                        static_cast<long>(found.above_one), static_cast<long>(found.below_zero),
                        static_cast<long>(found.beyond)});
}

/// How many results are how far from the truth.
Table ulps_table(const bench::FloatErrors& found) {
  Table table{{"ulps", "floats", "share"}};
  std::size_t last = found.ulps.size();
  while (last > 1 && found.ulps[last - 1] == 0) --last;
  for (std::size_t i = 0; i < last; ++i) {
    const std::uint64_t low = i == 0 ? 0 : std::uint64_t{1} << (i - 1), high = (std::uint64_t{1} << i) - 1;
    table.rows.push_back(
        {low >= high ? fmt::to_string(low) : fmt::format("{} .. {}", low, high),
         static_cast<long>(found.ulps[i]),
         Number{static_cast<double>(found.ulps[i]) / static_cast<double>(found.count()), 4}});
  }
  return table;
}

}  // namespace

Outcome exhaustive_command(const BenchOptions& options, const Watched& work) {
  const std::vector<forms::Target> catalogue = forms::catalogue();
  const std::vector<bench::SweptForm> swept = swept_forms(catalogue, options);
  const bool is_one = *options.exhaustive != "all";
  if (!is_one) require_writable(options.out);
  const Sweeper sweeper = options.device ? sweeper_on_device(options) : Sweeper{"", bench::subject_of};
  Table table{{"form", "constants", "floats", "max abs error", "at c", "max ulps", "at c ", "NaN", "above 1",
               "below 0", "beyond"}};
  const auto show = bar(work, "exhaustive");
  std::string beyond, histogram;
  for (const bench::SweptForm& form : swept) {
    const bench::FloatErrors found =
        bench::errors_on(sweeper.subject(form), options.range, [&](double share) {
          show((static_cast<double>(table.rows.size()) + share) / static_cast<double>(swept.size()));
        });
    append_row(table, form, found);
    const std::string& set = form.constants->id;
    for (const std::uint32_t at : found.beyond_at)
      beyond += fmt::format("beyond the bound: {}{} at c = {} ({:.6g})\n", form.form->id,
                            set == "none" ? "" : ", " + set, hex_place(at), std::bit_cast<float>(at));
    if (is_one) histogram = "\n" + write_console(ulps_table(found), Precision::report, options.terminal);
  }
  Outcome outcome{beyond.empty() ? 0 : 1,
                  (sweeper.device.empty() ? "" : "on " + sweeper.device + "\n") +
                      write_console(table, Precision::report, options.terminal) + beyond + histogram,
                  ""};
  if (is_one) return outcome;
  if (options.device) {
    table.columns.emplace_back("device");
    for (auto& row : table.rows) row.emplace_back(sweeper.device);
  }
  const File file{"errors.csv", write_csv(table, Precision::report)};
  outcome.out +=
      fmt::format("\nResult: {}\n", printable((std::filesystem::path(options.out) / file.name).string()));
  outcome.put = prepare_output(options.out, {file}, {}, options.force, work.checkpoint);
  return outcome;
}

}  // namespace shadefit
