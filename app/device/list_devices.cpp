#include <fmt/format.h>

#include "app/options/bench_options.hpp"
#include "bench/device/vulkan_device.hpp"
#include "fit/support/user_error.hpp"
#include "reports/table/table.hpp"
#include "reports/table/writers.hpp"

/// `bench --list-devices`.
namespace shadefit {

Outcome list_devices_command(const BenchOptions& options) {
  Table table{{"device", "name", "kind", "driver", "Vulkan", "half"}, {}};
  std::size_t place = 0;
  for (const device::DeviceInfo& info : device::vulkan_devices())
    table.rows.push_back({fmt::format("vulkan:{}", place++), info.name, info.kind, info.driver, info.vulkan,
                          std::string(info.has_half ? "yes" : "no")});
  if (table.rows.empty()) throw UserError("no Vulkan device of this machine can compute");
  return {0, write_console(table, Precision::report, options.terminal), ""};
}

}  // namespace shadefit
