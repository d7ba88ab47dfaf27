#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "app/options/bench_options.hpp"
#include "app/shards/swept_form.hpp"
#include "bench/device/form_sweep.hpp"
#include "bench/exhaustive/sweep.hpp"

/// Sweeps over every float whose states are kept in files, so that a stopped one can go on.
namespace shadefit {

/// A graphics device, and how wrong its functions are.
struct MeasuredDevice {
  std::shared_ptr<device::SweptDevice> device;
  GpuModel model;
};

/// The device at this place, measured for forms with such a function; none for a CPU.
std::optional<MeasuredDevice> measured_device(std::optional<std::size_t> place, forms::Function function,
                                              const Checkpoint& checkpoint);

/// A sweep with its file.
struct KeptSweep {
  SweptForm form;
  std::filesystem::path path;
  bench::Sweep sweep;
  bench::FloatSubject subject;
};

/// A new sweep, or the saved one in the directory `out`. Throws UserError if the saved one is of other work.
KeptSweep opened(const BenchOptions& options, const std::filesystem::path& out,
                 const forms::Catalogue& catalogue, const SweptForm& chosen,
                 const std::optional<MeasuredDevice>& on);

/// Sweeps the remaining floats of forms of one target, on one device or several. Saves the states now and
/// then, and at the end; so too when a signal ends the sweeps, which is the outcome then.
std::optional<Outcome> sweep_and_keep(std::vector<KeptSweep>& all, const Checkpoint& checkpoint,
                                      const Progress& progress);

}  // namespace shadefit
