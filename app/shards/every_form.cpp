#include "app/shards/every_form.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "app/shards/kept_sweep.hpp"
#include "bench/exhaustive/shared_truth.hpp"
#include "fit/support/hex_float.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/files.hpp"
#include "reports/io/output.hpp"
#include "reports/io/utf8.hpp"
#include "reports/table/writers.hpp"

namespace shadefit {
namespace {

namespace fs = std::filesystem;

/// Every form on a device, or on the CPU: a row each in a file of its own directory.
struct FormsOn {
  std::optional<MeasuredDevice> on;
  fs::path out;
  Table table{{"form", "constants", "floats", "max abs error", "at c", "max ulps", "at c ", "NaN", "beyond"},
              {}};

  fs::path path() const { return without_detours(out) / "errors.csv"; }
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

void add_row(Table& table, const KeptSweep& kept) {
  const bench::FloatErrors& found = kept.sweep.found;
  table.rows.push_back({std::string(kept.form.form->id), kept.form.constants->id,
                        static_cast<long>(found.count()), Number{static_cast<double>(found.max_abs_error), 6},
                        hex_text(std::bit_cast<float>(found.max_abs_error_at)),
                        static_cast<long>(found.max_ulps), hex_text(std::bit_cast<float>(found.max_ulps_at)),
                        static_cast<long>(found.nans), static_cast<long>(found.beyond)});
}

/// Writes the table of a device, and returns it as text.
std::string finished(const FormsOn& place, const Terminal& terminal) {
  Table in_file = place.table;
  std::string text;
  if (place.on) {
    const std::string name = device::name_with_driver(place.on->device->vulkan.info());
    in_file = with_column(in_file, "device", name);
    text = fmt::format("on {}\n", name);
  }
  write_files(place.out, {{place.path().filename().string(), write_csv(in_file, Precision::report)}});
  return text + write_console(place.table, Precision::report, terminal) +
         fmt::format("\nResult: {}\n", printable(place.path().string()));
}

}  // namespace

Outcome sweep_every_form(const BenchOptions& options, const forms::Catalogue& catalogue,
                         const std::string& version, const Checkpoint& checkpoint, const Progress& progress) {
  if (options.shard || options.constants)
    throw UserError(fmt::format("--exhaustive 'all' does not apply with {}: it takes every set of every form",
                                options.shard ? "--shard" : "--constants"));
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
        together.push_back(opened(options, place.out, catalogue, form, place.on, version));
      }
    }
    std::vector<bench::FloatSubject*> subjects;
    for (KeptSweep& kept : together) subjects.push_back(&kept.subject);
    bench::share_truth(subjects);
    if (auto interrupted = sweep_and_keep(together, checkpoint, progress)) return *interrupted;
    for (std::size_t i = 0; i < together.size(); ++i) {  // all forms of a place, then those of the next
      add_row(places[i / (end - first)].table, together[i]);
      beyond += together[i].sweep.found.beyond;
    }
  }
  std::vector<std::string> texts;
  for (const FormsOn& place : places) texts.push_back(finished(place, options.terminal));
  return {beyond == 0 ? 0 : 1, fmt::format("{}", fmt::join(texts, "\n")), ""};
}

}  // namespace shadefit
