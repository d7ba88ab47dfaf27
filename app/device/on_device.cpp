#include <fmt/format.h>

#include <memory>

#include "app/device/device_commands.hpp"
#include "bench/device/form_sweep.hpp"
#include "bench/device/measure_device.hpp"
#include "bench/tradeoff/timed_forms.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/table.hpp"
#include "reports/io/writers.hpp"

namespace shadefit {

Outcome list_devices_command(const BenchOptions& options) {
  Table table{{"device", "name", "kind", "driver", "Vulkan", "half"}};
  std::size_t place = 0;
  for (const device::DeviceInfo& info : device::vulkan_devices())
    table.rows.push_back({fmt::format("vulkan:{}", place++), info.name, info.kind, info.driver, info.vulkan,
                          std::string(info.has_half ? "yes" : "no")});
  if (table.rows.empty()) throw UserError("no Vulkan device of this machine can compute");
  return {0, write_console(table, Precision::report, options.terminal), ""};
}

bench::Trade trade_on_device(const BenchOptions& options, const std::function<bench::Trade()>& forms,
                             const Watched& work) {
  const auto plan = options.quick ? device::quick_device_plan : device::full_device_plan;
  device::VulkanDevice for_times({.place = *options.device, .has_buffers_on_device = true});
  device::VulkanDevice for_values({.place = *options.device});
  return device::measure_on_device(for_times, for_values, forms(), plan, bar(work, "bench"));
}

Sweeper sweeper_on_device(const BenchOptions& options) {
  const auto device = std::make_shared<device::VulkanDevice>(device::DeviceChoice{.place = *options.device});
  return {device->info().name + ", " + device->info().driver, [device](const bench::SweptForm& form) {
            bench::FloatSubject subject = bench::subject_of(form);
            device::sweep_on_device(subject, *device,
                                    bench::function_of(*form.target, *form.form, *form.constants), usual_gpu);
            return subject;
          }};
}

}  // namespace shadefit
