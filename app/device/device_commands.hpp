#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "app/options/bench_options.hpp"
#include "bench/forms/swept_form.hpp"
#include "bench/tradeoff/timed_forms.hpp"

/// What `bench` does on graphics devices. A build without SHADEFIT_DEVICE has only app/device/no_device.cpp,
/// in which each function throws a UserError that names the option and the packages.
namespace shadefit {

/// `bench --list-devices`: a line for each device.
Outcome list_devices_command(const BenchOptions& options);

/// `bench --probe`: the errors of the functions of a device.
Outcome probe_command(const BenchOptions& options, const Checkpoint& checkpoint);

/// `bench --device`: times and errors of forms; these are made once the device is open.
bench::Trade trade_on_device(const BenchOptions& options, const std::function<bench::FormsToTime()>& forms,
                             const Checkpoint& checkpoint, const Progress& progress);

/// What sweeps: this processor or a graphics device.
struct Sweeper {
  std::string device = {};              ///< its name and driver; empty for the processor
  std::string bound = {};               ///< a line about the bound of its results
  std::string_view numbers = "floats";  ///< or "halves"
  std::string_view file = "errors.csv";
  /// The errors of a form. `between` gets the finished share of it.
  std::function<bench::FloatErrors(const bench::SweptForm&, const std::function<void(double)>& between)>
      errors;
};

/// `bench --exhaustive --device`: sweeps floats, or with --half the halves. Measures first what the bounds of
/// the forms need. Throws UserError if the device has no half.
Sweeper sweeper_on_device(const forms::Catalogue& catalogue, const BenchOptions& options,
                          const std::vector<bench::SweptForm>& swept, const Checkpoint& checkpoint);

}  // namespace shadefit
