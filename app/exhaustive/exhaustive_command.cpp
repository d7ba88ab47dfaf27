#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "app/exhaustive/exhaustive.hpp"
#include "app/exhaustive/swept_form.hpp"
#include "app/options/bench_options.hpp"
#include "app/output/output_file.hpp"
#include "bench/device/form_sweep.hpp"
#include "bench/device/probe.hpp"
#include "bench/timing/machine.hpp"
#include "bench/timing/timing.hpp"
#include "fit/support/hex_float.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/files.hpp"
#include "reports/io/utf8.hpp"
#include "reports/table/writers.hpp"

/// `bench --exhaustive`: every float through one form, or through each of one cosine.
namespace shadefit {
namespace {

/// A graphics device, and how wrong its functions are.
struct MeasuredDevice {
  std::shared_ptr<device::SweptDevice> device;
  GpuModel model;
};

/// The device at this place, measured for forms with such a function; none for a CPU.
std::optional<MeasuredDevice> measured_device(std::optional<std::size_t> place, forms::Function function,
                                              const Checkpoint& checkpoint) {
  if (!place) return std::nullopt;
  auto made = std::make_shared<device::SweptDevice>(device::VulkanDevice({.place = *place}));
  const GpuModel model = device::model_for(function, made->vulkan, checkpoint);
  return MeasuredDevice{std::move(made), model};
}

/// The form on this processor, or on a graphics device.
bench::FloatSubject subject_on(const forms::Catalogue& catalogue, const SweptForm& chosen,
                               const std::optional<MeasuredDevice>& on) {
  bench::FloatSubject subject = subject_of(catalogue, chosen);
  if (on)
    device::sweep_on_device(subject, on->device,
                            device::form_function(*chosen.target, *chosen.form, *chosen.constants),
                            on->model);
  return subject;
}

/// The errors on a stretch, batch by batch, so that it can be interrupted. `first` of `of` forms.
bench::FloatErrors sweep(const bench::FloatSubject& subject, const bench::Stretch& whole, std::size_t first,
                         std::size_t of, const Checkpoint& checkpoint, const Progress& progress,
                         double start) {
  constexpr std::uint32_t batch = 1U << 22;  // about 50 ms on two threads
  bench::FloatErrors found;
  for (std::uint32_t from = whole.from; from < whole.to;) {
    checkpoint();
    const auto to =
        static_cast<std::uint32_t>(std::min<std::uint64_t>(whole.to, std::uint64_t{from} + batch));
    include(found, errors_on(subject, bench::Stretch{from, to}, bench::this_machine().threads));
    from = to;
    const double part = static_cast<double>(from - whole.from) / static_cast<double>(whole.size());
    const double share = (static_cast<double>(first) + part) / static_cast<double>(of);
    progress(progress_line("exhaustive", share, bench::now().real - start));
  }
  return found;
}

std::string place_text(std::uint32_t at) {
  if (at == UINT32_MAX) return "";
  const auto c = static_cast<double>(std::bit_cast<float>(at));
  return fmt::format("at c = {} ({:.6g})", hex_text(c), c);
}

/// The device and its bound; nothing for a CPU.
std::string device_text(const bench::FloatErrors& found, const std::optional<MeasuredDevice>& on) {
  if (!on) return "";
  const std::vector<double> e = device::numbers_of(on->model);
  std::string text = fmt::format(
      "on {}\nbound for exp2 within {:.4g} ulp, log2 within {:.4g} and within {:.4g} between 1/2 and 2: "
      "{} results are beyond it\n",
      device::name_with_driver(on->device->vulkan.info()), e.at(0), e.at(1), e.at(2), found.beyond);
  for (const std::uint32_t at : found.beyond_at) {
    if (at != UINT32_MAX) text += "  " + place_text(at) + "\n";
  }
  return text;
}

std::string result_text(const bench::FloatErrors& found, const SweptForm& chosen,
                        const std::optional<MeasuredDevice>& on, const Terminal& terminal) {
  std::string text =
      fmt::format("{}{} in {}: {} floats, against {} in double\n", words_of(chosen),
                  chosen.exp2_degree > 0 ? fmt::format(", exp2 of degree {}", chosen.exp2_degree) : "",
                  on ? "float" : forms::name(chosen.width), found.count(), chosen.target->text);
  text += fmt::format("max abs error  {:.6g} {}\nmax ulps       {} {}\nNaN {}, above 1 {}, below 0 {}\n{}\n",
                      found.max_abs_error, place_text(found.max_abs_error_at), found.max_ulps,
                      place_text(found.max_ulps_at), found.nans, found.above_one, found.below_zero,
                      device_text(found, on));
  return text + write_console(ulps_table(found.ulps, found.count(), "floats"), Precision::report, terminal);
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

Outcome sweep_one(const BenchOptions& options, const forms::Catalogue& catalogue,
                  const Checkpoint& checkpoint, const Progress& progress) {
  const SweptForm chosen = chosen_by(catalogue, options);
  const auto on = measured_device(options.device, chosen.form->function, checkpoint);
  const bench::FloatErrors found =
      sweep(subject_on(catalogue, chosen, on), options.range, 0, 1, checkpoint, progress, bench::now().real);
  return {found.beyond == 0 ? 0 : 1, result_text(found, chosen, on, options.terminal), ""};
}

/// Every form of one cosine with every set of its constants: a table, and the file errors.csv.
Outcome sweep_all(const BenchOptions& options, const forms::Catalogue& catalogue,
                  const Checkpoint& checkpoint, const Progress& progress) {
  if (options.constants)
    throw UserError("--exhaustive 'all' does not apply with --constants: it takes every set of every form");
  const OutputFolder folder(options.out);
  // pow is measured with all that other forms need.
  const auto on = measured_device(options.device, forms::Function::pow, checkpoint);
  Table table{{"form", "constants", "floats", "max abs error", "at c", "max ulps", "at c ", "NaN", "beyond"}};
  std::uint64_t beyond = 0;
  const double start = bench::now().real;
  const std::vector<SweptForm> all = all_of_one_cosine(catalogue);
  for (SweptForm form : all) {
    form.exp2_degree = options.exp2_degree;
    form.width = options.width.value_or(form.width);
    const bench::FloatErrors found = sweep(subject_on(catalogue, form, on), options.range, table.rows.size(),
                                           all.size(), checkpoint, progress, start);
    table.rows.push_back(row_of(form, found));
    beyond += found.beyond;
  }
  const std::string device = on ? device::name_with_driver(on->device->vulkan.info()) : "";
  const File file{"errors.csv",
                  write_csv(on ? with_column(table, "device", device) : table, Precision::report)};
  return {beyond == 0 ? 0 : 1,
          fmt::format("{}{}\nResult: {}\n", on ? "on " + device + "\n" : "",
                      write_console(table, Precision::report, options.terminal),
                      printable((without_detours(options.out) / file.name).string())),
          "", folder.prepare({file}, {}, options.force, checkpoint)};
}

}  // namespace

Table ulps_table(std::span<const std::uint64_t> ulps, std::uint64_t count, const std::string& numbers) {
  Table table{{"ulps", numbers, "share"}};
  std::size_t last = ulps.size();
  while (last > 1 && ulps[last - 1] == 0) --last;
  for (std::size_t i = 0; i < last; ++i) {
    const std::uint64_t low = i == 0 ? 0 : std::uint64_t{1} << (i - 1), high = (std::uint64_t{1} << i) - 1;
    table.rows.push_back(
        {low >= high ? fmt::to_string(low) : fmt::format("{} .. {}", low, high), static_cast<long>(ulps[i]),
         Number{static_cast<double>(ulps[i]) / static_cast<double>(std::max<std::uint64_t>(count, 1)), 4}});
  }
  return table;
}

Outcome exhaustive_command(const BenchOptions& options, const Checkpoint& checkpoint,
                           const Progress& progress) {
  if (options.half) return halves_command(options, checkpoint, progress);
  const forms::Catalogue catalogue = forms::catalogue();
  const auto run = *options.exhaustive == every_form ? sweep_all : sweep_one;
  return run(options, catalogue, checkpoint, progress);
}

}  // namespace shadefit
