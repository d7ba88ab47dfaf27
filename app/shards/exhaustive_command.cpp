#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "app/options/bench_options.hpp"
#include "app/shards/halves_command.hpp"
#include "app/shards/swept_form.hpp"
#include "app/terminal/interrupt.hpp"
#include "bench/device/form_sweep.hpp"
#include "bench/device/probe.hpp"
#include "bench/exhaustive/shared_truth.hpp"
#include "bench/exhaustive/state_file.hpp"
#include "bench/forms/catalogue.hpp"
#include "bench/timing/machine.hpp"
#include "bench/timing/timing.hpp"
#include "fit/support/hex_float.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/files.hpp"
#include "reports/io/output.hpp"
#include "reports/io/utf8.hpp"
#include "reports/table/writers.hpp"

/// `bench --exhaustive`: every float through one form.
namespace shadefit {
namespace {

namespace fs = std::filesystem;
using bench::Sweep;

bench::SweepIdentity identity_of(const SweptForm& chosen, const BenchOptions& options,
                                 const std::string& version) {
  return {version,
          std::string(chosen.form->id),
          chosen.exp2_degree,
          chosen.constants->numbers.empty() ? "" : chosen.constants->id,
          in_float(forms::parameters_of(*chosen.target, *chosen.constants)),
          std::string(forms::name(chosen.width)),
          options.range};
}

/// A graphics device, and how wrong its functions are.
struct MeasuredDevice {
  std::shared_ptr<device::SweptDevice> device;
  GpuModel model;
};

/// What the options name, measured for forms with such a function; none for a CPU.
std::optional<MeasuredDevice> measured_device(const BenchOptions& options, forms::Function function,
                                              const Checkpoint& checkpoint) {
  if (!options.device) return std::nullopt;
  auto made = std::make_shared<device::SweptDevice>(device::VulkanDevice({.place = *options.device}));
  const GpuModel model = device::model_for(function, made->vulkan, checkpoint);
  return MeasuredDevice{std::move(made), model};
}

/// The form on a graphics device in the place of this processor.
void put_on_device(bench::FloatSubject& subject, bench::SweepIdentity& identity, const SweptForm& chosen,
                   const MeasuredDevice& on) {
  const device::FormSweep sweep(
      on.device, device::form_function(*chosen.target, *chosen.form, *chosen.constants), on.model);
  sweep.take_over(subject);
  identity.width = "vulkan";
  identity.device = sweep.device();
  identity.bound_from = device::numbers_of(on.model);
}

/// The saved state, which must belong to this sweep; empty if there is none.
std::optional<Sweep> state_at(const fs::path& path, const Sweep& wanted) {
  std::error_code error;
  if (!fs::exists(fs::symlink_status(path, error))) return std::nullopt;
  const auto [name, sweep] = bench::read_state(path);
  const auto in_words = [](const Sweep& of) {
    WorkIdentity words = bench::identity_in_words(of.identity);
    words.emplace_back("shard", text_of(of.shard));
    return words;
  };
  if (const std::string other = difference(in_words(sweep), in_words(wanted)); !other.empty())
    throw UserError(fmt::format("{} is of {}; name another directory by --out", name, other));
  return sweep;
}

std::string place_text(std::uint32_t at) {
  if (at == UINT32_MAX) return "";
  const auto c = static_cast<double>(std::bit_cast<float>(at));
  return fmt::format("at c = {} ({:.6g})", hex_text(c), c);
}

/// The device and its bound; nothing for a CPU.
std::string device_text(const Sweep& sweep) {
  if (sweep.identity.device.empty()) return "";
  const auto& e = sweep.identity.bound_from;
  std::string text = fmt::format(
      "on {}\nbound for exp2 within {:.4g} ulp, log2 within {:.4g} and within {:.4g} between 1/2 and 2: "
      "{} results are beyond it\n",
      sweep.identity.device, e.at(0), e.at(1), e.at(2), sweep.found.beyond);
  for (const std::uint32_t at : sweep.found.beyond_at) {
    if (at != UINT32_MAX) text += "  " + place_text(at) + "\n";
  }
  return text;
}

std::string result_text(const Sweep& sweep, const SweptForm& chosen, const Terminal& terminal) {
  const bench::FloatErrors& found = sweep.found;
  std::string text =
      fmt::format("{}{} in {}: {} floats, against {} in double\n", words_of(chosen),
                  chosen.exp2_degree > 0 ? fmt::format(", exp2 of degree {}", chosen.exp2_degree) : "",
                  sweep.identity.device.empty() ? forms::name(chosen.width) : "float", found.count(),
                  chosen.target->text);
  text += fmt::format("max abs error  {:.6g} {}\nmax ulps       {} {}\nNaN {}, above 1 {}, below 0 {}\n{}\n",
                      found.max_abs_error, place_text(found.max_abs_error_at), found.max_ulps,
                      place_text(found.max_ulps_at), found.nans, found.above_one, found.below_zero,
                      device_text(sweep));
  Table table{{"ulps", "floats", "share"}, {}};
  std::size_t last = found.ulps.size();
  while (last > 1 && found.ulps[last - 1] == 0) --last;
  for (std::size_t i = 0; i < last; ++i) {
    const std::uint64_t low = i == 0 ? 0 : std::uint64_t{1} << (i - 1), high = (std::uint64_t{1} << i) - 1;
    table.rows.push_back({low >= high ? fmt::to_string(low) : fmt::format("{} .. {}", low, high),
                          static_cast<long>(found.ulps[i]),
                          Number{static_cast<double>(found.ulps[i]) /
                                     static_cast<double>(std::max<std::uint64_t>(found.count(), 1)),
                                 4}});
  }
  return text + write_console(table, Precision::report, terminal);
}

/// The finished fraction of a sweep.
double share_of(const Sweep& sweep) {
  const bench::Stretch all = sweep.stretch();
  return all.size() == 0 ? 1 : static_cast<double>(sweep.next - all.from) / static_cast<double>(all.size());
}

/// A sweep with its file.
struct KeptSweep {
  SweptForm form;
  fs::path path;
  Sweep sweep;
  bench::FloatSubject subject;

  void keep() const { bench::keep_state(path, sweep); }
  std::string shown() const { return printable(path.string()); }
};

/// A new sweep, or the saved one.
KeptSweep opened(const BenchOptions& options, const forms::Catalogue& catalogue, const SweptForm& chosen,
                 const std::optional<MeasuredDevice>& on, const std::string& version) {
  KeptSweep kept{chosen, {}, {}, subject_of(catalogue, chosen)};
  bench::SweepIdentity identity = identity_of(chosen, options, version);
  if (on) put_on_device(kept.subject, identity, chosen, *on);
  kept.path = without_detours(options.out) / (options.shard ? shard_file : bench::file_of(identity));
  kept.sweep = bench::begin_sweep(identity, options.shard.value_or(Shard{}));
  if (const std::optional<Sweep> before = state_at(kept.path, kept.sweep)) {
    kept.sweep = *before;
  } else {
    kept.keep();  // detects a full disk now, not after a minute
  }
  return kept;
}

/// Sweeps the remaining floats of forms of one target. Saves the states now and then, and at the end; so too
/// when a signal ends the sweeps, which is the outcome then.
std::optional<Outcome> sweep_and_keep(std::vector<KeptSweep>& all, const Checkpoint& checkpoint,
                                      const Progress& progress) {
  std::vector<bench::RunningSweep> running;
  for (KeptSweep& kept : all) {
    if (!kept.sweep.is_done()) running.push_back({&kept.sweep, &kept.subject});
  }
  if (running.empty()) return std::nullopt;
  // Seconds of work that a killed process may lose.
  constexpr double longest_unkept = 10;
  const auto keep_all = [&] {
    for (const KeptSweep& kept : all) kept.keep();
  };
  const auto share = [&] { return share_of(*running.front().sweep); };
  const double start = bench::now().real, share_before = share();
  double kept_at = start;
  const auto between = [&] {
    const double now = bench::now().real;
    if (now - kept_at > longest_unkept) {
      keep_all();
      kept_at = now;
    }
    progress(progress_line("exhaustive", share(), (now - start) * share() / (share() - share_before)));
    if (share() < 1) checkpoint();
  };
  try {
    checkpoint();
    bench::go_on_together(running, bench::this_machine().threads, between);
  } catch (const Interrupted& interrupted) {
    keep_all();
    return Outcome{128 + interrupted.signal, "",
                   fmt::format("shadefit: interrupted at {:.1f} %: the same command goes on from '{}'\n",
                               100 * share(), all.front().shown())};
  }
  keep_all();
  return std::nullopt;
}

Outcome sweep_one(const BenchOptions& options, const forms::Catalogue& catalogue, const std::string& version,
                  const Checkpoint& checkpoint, const Progress& progress) {
  const SweptForm chosen = chosen_by(catalogue, options);
  const auto on = measured_device(options, chosen.form->function, checkpoint);
  std::vector<KeptSweep> all{opened(options, catalogue, chosen, on, version)};
  if (auto interrupted = sweep_and_keep(all, checkpoint, progress)) return *interrupted;
  const Sweep& sweep = all.front().sweep;
  const std::string text =
      options.format == FindingFormat::json
          ? bench::state_text(sweep)
          : result_text(sweep, chosen, options.terminal) + fmt::format("\nResult: {}\n", all.front().shown());
  return {sweep.found.beyond == 0 ? 0 : 1, text, ""};
}

/// Every form of one cosine with every set of its constants. Those of one target go together.
Outcome sweep_all(const BenchOptions& options, const forms::Catalogue& catalogue, const std::string& version,
                  const Checkpoint& checkpoint, const Progress& progress) {
  if (options.shard || options.constants)
    throw UserError(fmt::format("--exhaustive 'all' does not apply with {}: it takes every set of every form",
                                options.shard ? "--shard" : "--constants"));
  constexpr const char* file = "errors.csv";
  const auto on = measured_device(options, forms::Function::pow, checkpoint);
  Table table{{"form", "constants", "floats", "max abs error", "at c", "max ulps", "at c ", "NaN", "beyond"},
              {}};
  std::uint64_t beyond = 0;
  const std::vector<SweptForm> forms = all_of_one_cosine(catalogue);
  for (std::size_t i = 0; i < forms.size();) {
    std::vector<KeptSweep> together;
    for (const forms::Target* target = forms[i].target; i < forms.size() && forms[i].target == target; ++i) {
      SweptForm form = forms[i];
      form.exp2_degree = options.exp2_degree;
      form.width = options.width.value_or(form.width);
      together.push_back(opened(options, catalogue, form, on, version));
    }
    std::vector<bench::FloatSubject*> subjects;
    for (KeptSweep& kept : together) subjects.push_back(&kept.subject);
    bench::share_truth(subjects);
    if (auto interrupted = sweep_and_keep(together, checkpoint, progress)) return *interrupted;
    for (const auto& [form, path, sweep, subject] : together) {
      const bench::FloatErrors& found = sweep.found;
      beyond += found.beyond;
      table.rows.push_back({std::string(form.form->id), form.constants->id, static_cast<long>(found.count()),
                            Number{static_cast<double>(found.max_abs_error), 6},
                            hex_text(std::bit_cast<float>(found.max_abs_error_at)),
                            static_cast<long>(found.max_ulps),
                            hex_text(std::bit_cast<float>(found.max_ulps_at)), static_cast<long>(found.nans),
                            static_cast<long>(found.beyond)});
    }
  }
  Table in_file = table;
  if (on) append_column(in_file, "device", device::name_with_driver(on->device->vulkan.info()));
  write_files(options.out, {{file, write_csv(in_file, Precision::report)}});
  return {beyond == 0 ? 0 : 1,
          write_console(table, Precision::report, options.terminal) +
              fmt::format("\nResult: {}\n", printable((without_detours(options.out) / file).string())),
          ""};
}

}  // namespace

Outcome exhaustive_command(const BenchOptions& options, const std::string& version,
                           const Checkpoint& checkpoint, const Progress& progress) {
  require_directory(options.out);
  if (options.half) return halves_command(options, checkpoint, progress);
  const forms::Catalogue catalogue = forms::catalogue();
  const auto sweep = *options.exhaustive == "all" ? sweep_all : sweep_one;
  return sweep(options, catalogue, version, checkpoint, progress);
}

}  // namespace shadefit
