#include "app/exhaustive/exhaustive.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/exhaustive/swept_form.hpp"
#include "bench/device/form_functions.hpp"
#include "bench/device/half_errors.hpp"
#include "bench/timing/timing.hpp"
#include "fit/support/hex_float.hpp"
#include "reports/io/files.hpp"
#include "reports/io/output.hpp"
#include "reports/io/utf8.hpp"
#include "reports/table/writers.hpp"

namespace shadefit {
namespace {

/// The first places beyond a bound, in a line each.
std::string places_text(const SweptForm& form, const std::vector<double>& places) {
  constexpr std::size_t most = 8;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, places.size()); ++i)
    text += fmt::format("beyond the bound: {} at c = {} ({:.6g})\n", words_of(form), hex_text(places[i]),
                        places[i]);
  return text;
}

std::vector<Cell> row_of(const SweptForm& form, const device::HalfErrors& found) {
  return {std::string(form.form->id),
          form.constants->id,
          static_cast<long>(found.count),
          Number{found.max_abs_error, 6},
          hex_text(found.max_abs_error_at),
          static_cast<long>(found.max_ulps),
          hex_text(found.max_ulps_at),
          static_cast<long>(found.nans),
          static_cast<long>(found.beyond.size()),
          static_cast<long>(found.unbounded)};
}

}  // namespace

Outcome halves_command(const BenchOptions& options, const Checkpoint& checkpoint, const Progress& progress) {
  const forms::Catalogue catalogue = forms::catalogue();
  const bool is_all = *options.exhaustive == every_form;
  const std::vector<SweptForm> swept =
      is_all ? all_of_one_cosine(catalogue) : std::vector{chosen_by(catalogue, options)};
  device::VulkanDevice vulkan({.place = *options.device});
  Table table{{"form", "constants", "halves", "max abs error", "at c", "max ulps", "at c ", "NaN", "beyond",
               "without bound"}};
  std::string beyond, histogram;
  const double start = bench::now().real;
  for (const SweptForm& form : swept) {
    checkpoint();
    const double share = static_cast<double>(table.rows.size()) / static_cast<double>(swept.size());
    if (share > 0) progress(progress_line("halves", share, bench::now().real - start));
    const device::FormFunction on_device = device::form_function(*form.target, *form.form, *form.constants);
    const device::HalfErrors found =
        device::errors_in_half(vulkan, on_device.function, subject_of(catalogue, form).truth, usual_gpu);
    table.rows.push_back(row_of(form, found));
    beyond += places_text(form, found.beyond);
    if (!is_all)
      histogram = "\n" + write_console(ulps_table(found.ulps, found.count, "halves"), Precision::report,
                                       options.terminal);
  }
  const std::string name = device::name_with_driver(vulkan.info());
  constexpr const char* file = "errors-half.csv";
  write_files(options.out, {{file, write_csv(with_column(table, "device", name), Precision::report)}});
  const std::string path = (without_detours(options.out) / file).string();
  const std::string text = fmt::format("on {}\n{}{}{}\nResult: {}\n", name,
                                       write_console(table, Precision::report, options.terminal), beyond,
                                       histogram, printable(path));
  return {beyond.empty() ? 0 : 1, text, ""};
}

}  // namespace shadefit
