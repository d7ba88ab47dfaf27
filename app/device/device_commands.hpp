#pragma once

#include <functional>
#include <string>

#include "app/options/options.hpp"
#include "app/output/progress.hpp"
#include "bench/forms/float_errors.hpp"
#include "bench/tradeoff/trade.hpp"

/// What `bench` does on graphics devices. A build without SHADEFIT_DEVICE has only app/device/no_device.cpp,
/// in which each function throws a UserError that names the option and the packages.
namespace shadefit {

/// `bench --list-devices`: a line for each device.
Outcome list_devices_command(const BenchOptions& options);

/// `bench --device`: times and errors of forms; these are made once the device is open.
bench::Trade trade_on_device(const BenchOptions& options, const std::function<bench::Trade()>& forms,
                             const Watched& work);

/// What evaluates forms: this processor or a graphics device.
struct Sweeper {
  std::string device;  ///< its name and driver; empty for the processor
  std::function<bench::FloatSubject(const bench::SweptForm&)> subject;
};

/// `bench --exhaustive --device`. The bound of each result is that of `usual_gpu`.
Sweeper sweeper_on_device(const BenchOptions& options);

}  // namespace shadefit
