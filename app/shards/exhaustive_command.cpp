#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <filesystem>
#include <system_error>

#include "app/options/bench_options.hpp"
#include "app/terminal/interrupt.hpp"
#include "bench/device/form_sweep.hpp"
#include "bench/device/probe.hpp"
#include "bench/exhaustive/state_file.hpp"
#include "bench/forms/catalogue.hpp"
#include "bench/timing/machine.hpp"
#include "bench/timing/timing.hpp"
#include "bench/tradeoff/measure.hpp"
#include "fit/support/hex_float.hpp"
#include "fit/support/known.hpp"
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

/// The form and its target that a sweep compares.
struct Chosen {
  const forms::FormEntry* form;
  const forms::Target* target;
  const forms::Constants* constants;
  int exp2_degree;
  forms::Width width;
};

const forms::FormEntry& find_form(const forms::Catalogue& catalogue, const std::string& id) {
  std::vector<std::string> known;
  for (const forms::FormEntry& form : catalogue.forms) {
    if (form.arguments == forms::Arguments::cosine) known.emplace_back(form.id);
    if (form.id != id) continue;
    if (form.arguments == forms::Arguments::cosine) return form;
    throw UserError(
        fmt::format("--exhaustive '{}' is not a form of one cosine: it reads {} of each element", id,
                    form.arguments == forms::Arguments::cosine_and_code ? "a gloss too" : "a normal"));
  }
  require_known(id, known, "form of one cosine");
  throw std::logic_error("a form that is known and was not found");
}

const forms::Constants& find_constants(const forms::FormEntry& form, const std::optional<std::string>& id) {
  if (!id) return form.constants.front();
  std::vector<std::string> known;
  for (const forms::Constants& constants : form.constants) {
    if (constants.id == *id) return constants;
    known.push_back(constants.id);
  }
  throw UserError(fmt::format("--constants '{}' is not a set of {}: it must be one of {}", *id, form.id,
                              fmt::join(known, ", ")));
}

Chosen chosen_by(const forms::Catalogue& catalogue, const BenchOptions& options) {
  const forms::FormEntry& form = find_form(catalogue, *options.exhaustive);
  return {&form, &forms::target_of(catalogue, form.target), &find_constants(form, options.constants),
          options.exp2_degree, options.width.value_or(forms::Width::sse2)};
}

/// The kernel of a form. Throws UserError for a degree that the form does not have.
const forms::CompiledForm find_kernel(const std::vector<forms::CompiledForm>& all, std::string_view form,
                                      int exp2_degree) {
  std::vector<int> known;
  for (const forms::CompiledForm& compiled : all) {
    if (compiled.form != form || compiled.in_float == nullptr) continue;
    if (compiled.exp2_degree == exp2_degree) return compiled;
    known.push_back(compiled.exp2_degree);
  }
  throw UserError(fmt::format("--exp2-degree '{}' is not compiled for {}: it must be one of {}", exp2_degree,
                              form, fmt::join(known, ", ")));
}

std::vector<float> in_float(const std::vector<double>& numbers) {
  std::vector<float> floats;
  for (const double number : numbers) floats.push_back(static_cast<float>(number));
  return floats;
}

/// The form in float. The reference is the target's formula in double, by the library. Its error is a few
/// last bits of a double: less than one for pow of the C library (as documented), half of one for 1 - c of a
/// float, multiplied by a power of some tens. One ulp of a float is 2^29 ulps of a double, so the reference
/// rounds to the right float, except within a millionth of the middle between two floats.
bench::FloatSubject subject_of(const forms::Catalogue& catalogue, const Chosen& chosen) {
  const auto form = find_kernel(bench::compiled_for(chosen.width), chosen.form->id, chosen.exp2_degree);
  const auto exact = std::find_if(catalogue.forms.begin(), catalogue.forms.end(), [&](const auto& other) {
    return other.target == chosen.target->id;  // the first form of a target is the target itself
  });
  const auto truth = find_kernel(forms::scalar_forms(), exact->id, 0);
  const auto parameters = in_float(forms::parameters_of(*chosen.target, *chosen.constants));
  const auto given = forms::parameters_of(*chosen.target, exact->constants.front());
  return {[=](const float* in, float* out, std::size_t count) {
            form.in_float({.in = {in}, .out = out, .size = count}, parameters);
          },
          [=](const float* in, double* out, std::size_t count) {
            // In pieces that fit on the stack, because several threads run here at once.
            std::array<double, 256> cosines;
            for (std::size_t first = 0; first < count; first += cosines.size()) {
              const std::size_t piece = std::min(cosines.size(), count - first);
              std::copy_n(in + first, piece, cosines.begin());
              truth.in_double({.in = {cosines.data()}, .out = out + first, .size = piece}, given);
            }
          }};
}

bench::SweepIdentity identity_of(const Chosen& chosen, const BenchOptions& options,
                                 const std::string& version) {
  return {version,
          std::string(chosen.form->id),
          chosen.exp2_degree,
          chosen.constants->numbers.empty() ? "" : chosen.constants->id,
          in_float(forms::parameters_of(*chosen.target, *chosen.constants)),
          std::string(forms::name(chosen.width)),
          options.range};
}

/// The form on a graphics device in the place of this processor.
void put_on_device(bench::FloatSubject& subject, bench::SweepIdentity& identity, const Chosen& chosen,
                   std::size_t place, const GpuModel& model) {
  const device::FormSweep sweep(device::VulkanDevice({.place = place}),
                                device::form_function(*chosen.target, *chosen.form, *chosen.constants),
                                model);
  sweep.take_over(subject);
  identity.width = "vulkan";
  identity.device = sweep.device();
  identity.bound_from = device::numbers_of(model);
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

std::string result_text(const Sweep& sweep, const Chosen& chosen, const Terminal& terminal) {
  const bench::FloatErrors& found = sweep.found;
  std::string text =
      fmt::format("{}{}{} in {}: {} floats, against {} in double\n", chosen.form->id,
                  chosen.constants->numbers.empty() ? "" : ", " + chosen.constants->id,
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

/// Sweeps the remaining floats. Saves the state now and then, and when a signal ends the sweep.
void sweep_and_keep(Sweep& sweep, const bench::FloatSubject& subject, const fs::path& path,
                    const Checkpoint& checkpoint, const Progress& progress) {
  // Seconds of work that a killed process may lose.
  constexpr double longest_unkept = 10;
  const double start = bench::now().real, share_before = share_of(sweep);
  double kept = start;
  const auto between = [&] {
    const double now = bench::now().real, share = share_of(sweep);
    if (now - kept > longest_unkept) {
      bench::keep_state(path, sweep);
      kept = now;
    }
    progress(progress_line("exhaustive", share, (now - start) * share / (share - share_before)));
    if (!sweep.is_done()) checkpoint();
  };
  checkpoint();
  bench::go_on(sweep, subject, bench::this_machine().threads, between);
}

/// Sweeps one form, or goes on with it, and keeps its result. On a device `model` says how wrong that is.
Outcome sweep_form(const BenchOptions& options, const forms::Catalogue& catalogue, const Chosen& chosen,
                   const GpuModel& model, const std::string& version, const Checkpoint& checkpoint,
                   const Progress& progress, Sweep& sweep) {
  bench::FloatSubject subject = subject_of(catalogue, chosen);
  bench::SweepIdentity identity = identity_of(chosen, options, version);
  if (options.device) put_on_device(subject, identity, chosen, *options.device, model);
  const fs::path path =
      without_detours(options.out) / (options.shard ? shard_file : bench::file_of(identity));
  const std::string shown = printable(path.string());

  sweep = bench::begin_sweep(identity, options.shard.value_or(Shard{}));
  const std::optional<Sweep> before = state_at(path, sweep);
  if (before) sweep = *before;
  if (!sweep.is_done()) {
    // This detects a full disk now, not after a minute.
    if (!before) bench::keep_state(path, sweep);
    try {
      sweep_and_keep(sweep, subject, path, checkpoint, progress);
    } catch (const Interrupted& interrupted) {
      bench::keep_state(path, sweep);
      return {128 + interrupted.signal, "",
              fmt::format("shadefit: interrupted at {:.1f} %: the same command goes on from '{}'\n",
                          100 * share_of(sweep), shown)};
    }
  }
  if (!before || !before->is_done()) bench::keep_state(path, sweep);
  const std::string text =
      options.format == FindingFormat::json
          ? bench::state_text(sweep)
          : result_text(sweep, chosen, options.terminal) + fmt::format("\nResult: {}\n", shown);
  return {sweep.found.beyond == 0 ? 0 : 1, text, ""};
}

/// What is known of the device before forms with such a function run on it; nothing of a CPU.
GpuModel measured_model(const BenchOptions& options, forms::Function function, const Checkpoint& checkpoint) {
  if (!options.device) return usual_gpu;
  device::VulkanDevice vulkan({.place = *options.device});
  return device::model_for(function, vulkan, checkpoint);
}

/// Every form of one cosine with every set of its constants, one after the other.
Outcome sweep_all(const BenchOptions& options, const forms::Catalogue& catalogue, const std::string& version,
                  const Checkpoint& checkpoint, const Progress& progress) {
  if (options.shard || options.constants)
    throw UserError(fmt::format("--exhaustive 'all' does not apply with {}: it takes every set of every form",
                                options.shard ? "--shard" : "--constants"));
  constexpr const char* file = "errors.csv";
  const GpuModel model = measured_model(options, forms::Function::pow, checkpoint);
  Table table{{"form", "constants", "floats", "max abs error", "at c", "max ulps", "at c ", "NaN", "beyond"},
              {}};
  std::uint64_t beyond = 0;
  for (const forms::FormEntry& form : catalogue.forms) {
    if (form.arguments != forms::Arguments::cosine) continue;
    for (const forms::Constants& constants : form.constants) {
      BenchOptions one = options;
      one.exhaustive = std::string(form.id);
      one.constants = constants.id;
      Sweep sweep;
      const Outcome outcome =
          sweep_form(one, catalogue, chosen_by(catalogue, one), model, version, checkpoint, progress, sweep);
      if (!sweep.is_done()) return outcome;
      const bench::FloatErrors& found = sweep.found;
      beyond += found.beyond;
      table.rows.push_back({std::string(form.id), constants.id, static_cast<long>(found.count()),
                            Number{static_cast<double>(found.max_abs_error), 6},
                            hex_text(std::bit_cast<float>(found.max_abs_error_at)),
                            static_cast<long>(found.max_ulps),
                            hex_text(std::bit_cast<float>(found.max_ulps_at)), static_cast<long>(found.nans),
                            static_cast<long>(found.beyond)});
    }
  }
  write_files(options.out, {{file, write_csv(table, Precision::report)}});
  return {beyond == 0 ? 0 : 1,
          write_console(table, Precision::report, options.terminal) +
              fmt::format("\nResult: {}\n", printable((without_detours(options.out) / file).string())),
          ""};
}

}  // namespace

Outcome exhaustive_command(const BenchOptions& options, const std::string& version,
                           const Checkpoint& checkpoint, const Progress& progress) {
  require_directory(options.out);
  const forms::Catalogue catalogue = forms::catalogue();
  if (*options.exhaustive == "all") return sweep_all(options, catalogue, version, checkpoint, progress);
  const Chosen chosen = chosen_by(catalogue, options);
  const GpuModel model = measured_model(options, chosen.form->function, checkpoint);
  Sweep sweep;
  return sweep_form(options, catalogue, chosen, model, version, checkpoint, progress, sweep);
}

}  // namespace shadefit
