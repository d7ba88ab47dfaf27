#include "app/shards/sweeps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <filesystem>
#include <optional>
#include <vector>

#include "app/shards/kept_sweep.hpp"
#include "fit/support/hex_float.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/files.hpp"
#include "reports/io/joined.hpp"
#include "reports/io/output.hpp"
#include "reports/io/utf8.hpp"
#include "reports/table/writers.hpp"

namespace shadefit {
namespace {

namespace fs = std::filesystem;

/// Every form on a device, or on the CPU, in a directory of its own.
struct FormsOn {
  std::optional<MeasuredDevice> on;
  fs::path out;
  std::vector<bench::Sweep> sweeps = {};
};

/// One for the CPU or the device that the options name; with `--all-devices` one for each device.
std::vector<FormsOn> places_of(const BenchOptions& options, const Checkpoint& checkpoint) {
  constexpr auto function = forms::Function::pow;  // measured with all that other forms need
  std::vector<FormsOn> places;
  if (!options.all_devices) {
    places.push_back({measured_device(options.device, function, checkpoint), options.out});
    return places;
  }
  const std::size_t count =
      std::max<std::size_t>(device::vulkan_devices().size(), 1);  // of none, 0 is refused
  for (std::size_t place = 0; place < count; ++place)
    places.push_back({measured_device(place, function, checkpoint),
                      fs::path(options.out) / fmt::format("vulkan-{}", place)});
  return places;
}

std::vector<Cell> row_of(const SweptForm& form, const bench::FloatErrors& found) {
  return {std::string(form.form->id),
          form.constants->id,
          static_cast<long>(found.count()),
          Number{static_cast<double>(found.max_abs_error), 6},
          hex_text(std::bit_cast<float>(found.max_abs_error_at)),
          static_cast<long>(found.max_ulps),
          hex_text(std::bit_cast<float>(found.max_ulps_at)),
          static_cast<long>(found.nans),
          static_cast<long>(found.beyond)};
}

Table table_of(const forms::Catalogue& catalogue, const std::vector<bench::Sweep>& sweeps) {
  Table table{{"form", "constants", "floats", "max abs error", "at c", "max ulps", "at c ", "NaN", "beyond"}};
  for (const SweptForm& form : all_of_one_cosine(catalogue)) {
    const auto sweep = std::ranges::find_if(sweeps, [&](const bench::Sweep& other) {
      return other.identity.form == form.form->id && other.identity.set == set_of(form);
    });
    if (sweep != sweeps.end()) table.rows.push_back(row_of(form, sweep->found));
  }
  return table;
}

/// Writes the table of a device, and returns it as text. A part has no table yet.
std::string finished(const FormsOn& place, const forms::Catalogue& catalogue, const BenchOptions& options) {
  const std::string device = place.sweeps.front().identity.device;
  const std::string on = device.empty() ? "" : fmt::format("on {}\n", device);
  const fs::path out = without_detours(place.out);
  if (options.shard)
    return fmt::format("{}Part {} of {} sweeps: {}\n", on, text_of(*options.shard), place.sweeps.size(),
                       printable(out.string()));
  const File file = errors_file(catalogue, place.sweeps);
  write_files(place.out, {file});
  return on + write_console(table_of(catalogue, place.sweeps), Precision::report, options.terminal) +
         fmt::format("\nResult: {}\n", printable((out / file.name).string()));
}

}  // namespace

Outcome sweep_every_form(const BenchOptions& options, const forms::Catalogue& catalogue,
                         const Checkpoint& checkpoint, const Progress& progress) {
  if (options.constants)
    throw UserError("--exhaustive 'all' does not apply with --constants: it takes every set of every form");
  std::vector<FormsOn> places = places_of(options, checkpoint);
  std::uint64_t beyond = 0;
  const std::vector<SweptForm> forms = all_of_one_cosine(catalogue);
  for (std::size_t first = 0, end = 0; first < forms.size(); first = end) {
    while (end < forms.size() && forms[end].target == forms[first].target) ++end;
    std::vector<KeptSweep> together;
    for (const FormsOn& place : places) {
      for (std::size_t i = first; i < end; ++i) {
        SweptForm form = forms[i];
        form.exp2_degree = options.exp2_degree;
        form.width = options.width.value_or(form.width);
        together.push_back(opened(options, place.out, catalogue, form, place.on));
      }
    }
    std::vector<bench::FloatSubject*> subjects;
    for (KeptSweep& kept : together) subjects.push_back(&kept.subject);
    bench::share_truth(subjects);
    if (auto interrupted = sweep_and_keep(together, checkpoint, progress)) return *interrupted;
    for (std::size_t i = 0; i < together.size(); ++i) {  // all forms of a place, then those of the next
      places[i / (end - first)].sweeps.push_back(together[i].sweep);
      beyond += together[i].sweep.found.beyond;
    }
  }
  const auto finish = [&](const FormsOn& place) { return finished(place, catalogue, options); };
  return {beyond == 0 ? 0 : 1, joined(places, "\n", finish), ""};
}

File errors_file(const forms::Catalogue& catalogue, const std::vector<bench::Sweep>& sweeps) {
  Table table = table_of(catalogue, sweeps);
  const std::string& device = sweeps.front().identity.device;
  if (!device.empty()) table = with_column(table, "device", device);
  return {"errors.csv", write_csv(table, Precision::report)};
}

}  // namespace shadefit
