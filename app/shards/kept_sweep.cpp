#include "app/shards/kept_sweep.hpp"

#include <fmt/format.h>

#include <system_error>
#include <utility>

#include "app/terminal/interrupt.hpp"
#include "bench/device/probe.hpp"
#include "bench/exhaustive/state_file.hpp"
#include "bench/timing/machine.hpp"
#include "bench/timing/timing.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/files.hpp"
#include "reports/io/utf8.hpp"

namespace shadefit {
namespace {

namespace fs = std::filesystem;
using bench::Sweep;

bench::SweepIdentity identity_of(const SweptForm& chosen, const BenchOptions& options) {
  return {SHADEFIT_VERSION,
          std::string(chosen.form->id),
          chosen.exp2_degree,
          set_of(chosen),
          in_float(forms::parameters_of(*chosen.target, *chosen.constants)),
          std::string(forms::name(chosen.width)),
          options.range};
}

/// The form on a graphics device instead of this processor.
void put_on_device(bench::FloatSubject& subject, bench::SweepIdentity& identity, const SweptForm& chosen,
                   const MeasuredDevice& on) {
  device::sweep_on_device(subject, on.device,
                          device::form_function(*chosen.target, *chosen.form, *chosen.constants), on.model);
  identity.width = "vulkan";
  identity.device = device::name_with_driver(on.device->vulkan.info());
  identity.bound_from = device::numbers_of(on.model);
}

/// The saved state; empty if there is none. Throws UserError if it belongs to another sweep.
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

/// The finished fraction of a sweep.
double share_of(const Sweep& sweep) {
  const bench::Stretch all = sweep.stretch();
  return all.size() == 0 ? 1 : static_cast<double>(sweep.next - all.from) / static_cast<double>(all.size());
}

}  // namespace

std::optional<MeasuredDevice> measured_device(std::optional<std::size_t> place, forms::Function function,
                                              const Checkpoint& checkpoint) {
  if (!place) return std::nullopt;
  auto made = std::make_shared<device::SweptDevice>(device::VulkanDevice({.place = *place}));
  const GpuModel model = device::model_for(function, made->vulkan, checkpoint);
  return MeasuredDevice{std::move(made), model};
}

KeptSweep opened(const BenchOptions& options, const fs::path& out, const forms::Catalogue& catalogue,
                 const SweptForm& chosen, const std::optional<MeasuredDevice>& on) {
  KeptSweep kept{chosen, {}, {}, subject_of(catalogue, chosen)};
  bench::SweepIdentity identity = identity_of(chosen, options);
  if (on) put_on_device(kept.subject, identity, chosen, *on);
  const bool is_one_part = options.shard && *options.exhaustive != every_form;
  kept.path = without_detours(out) / (is_one_part ? shard_file : bench::file_of(identity));
  kept.sweep = bench::begin_sweep(identity, options.shard.value_or(Shard{}));
  if (const std::optional<Sweep> before = state_at(kept.path, kept.sweep)) {
    kept.sweep = *before;
  } else {
    bench::keep_state(kept.path, kept.sweep);  // detects a full disk now, not after a minute
  }
  return kept;
}

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
    for (const KeptSweep& kept : all) bench::keep_state(kept.path, kept.sweep);
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
                               100 * share(), printable(all.front().path.string()))};
  }
  keep_all();
  return std::nullopt;
}

}  // namespace shadefit
