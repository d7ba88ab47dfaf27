#include <fmt/format.h>

#include "app/device/device_commands.hpp"
#include "bench/device/probe.hpp"
#include "bench/device/vulkan_device.hpp"
#include "fit/support/hex_float.hpp"
#include "fit/support/user_error.hpp"
#include "reports/io/joined.hpp"
#include "reports/table/table.hpp"
#include "reports/table/writers.hpp"

/// `bench --list-devices` and `bench --probe`.
namespace shadefit {
namespace {

using device::LargestError;

std::vector<Cell> row(const std::string& function, const std::string& range, const LargestError& found,
                      const std::string& unit) {
  return {function,
          range,
          static_cast<long>(found.count),
          Number{found.error, 4},
          unit,
          joined(found.at, ", ", hex_text)};
}

}  // namespace

Outcome list_devices_command(const BenchOptions& options) {
  Table table{{"device", "name", "kind", "driver", "Vulkan", "half"}};
  std::size_t place = 0;
  for (const device::DeviceInfo& info : device::vulkan_devices())
    table.rows.push_back({fmt::format("vulkan:{}", place++), info.name, info.kind, info.driver, info.vulkan,
                          std::string(info.has_half ? "yes" : "no")});
  if (table.rows.empty()) throw UserError("no Vulkan device of this machine can compute");
  return {0, write_console(table, Precision::report, options.terminal), ""};
}

Outcome probe_command(const BenchOptions& options, const Checkpoint& checkpoint) {
  device::VulkanDevice vulkan({.place = options.device.value()});
  const device::Probe found = device::probe(vulkan, device::ProbeExtent::all, checkpoint);
  Table table{
      {"function", "arguments", "tried", "largest error", "unit", "at"},
      {row("exp2(x)", "-126 .. 128", found.exp2, "ulp"),
       row("log2(x)", "outside of 1/2 .. 2", found.log2, "ulp"),
       row("log2(x)", "1/2 .. 2", found.log2_near_one, "absolute"),
       row("sqrt(x)", "normal", found.root, "ulp"), row("1/x", "2^-126 .. 2^126", found.reciprocal, "ulp"),
       row("x/y", "2^-60 .. 2^60", found.quotient, "ulp"),
       row("pow(x, y)", "1/256 .. 1, 1 .. 64", found.power, "ulp")}};
  if (vulkan.info().has_half) {
    const device::HalfProbe half = device::probe_halves(vulkan);
    constexpr const char* ulp = "ulp of a half";
    table.rows.push_back(row("exp2(x) in half", "-14 .. 16", half.exp2, ulp));
    table.rows.push_back(row("log2(x) in half", "outside of 1/2 .. 2", half.log2, ulp));
    table.rows.push_back(row("log2(x) in half", "1/2 .. 2", half.log2_near_one, "absolute"));
    table.rows.push_back(row("sqrt(x) in half", "normal", half.root, ulp));
    table.rows.push_back(row("1/x in half", "2^-14 .. 2^14", half.reciprocal, ulp));
  }
  const auto kept = [](bool is_kept) { return is_kept ? "kept" : "flushed to zero"; };
  return {0,
          fmt::format("{}, {}\n{}x y + z is {}; subnormal operands are {}, subnormal results {}\n{}",
                      vulkan.info().name, vulkan.info().driver,
                      write_console(table, Precision::report, options.terminal),
                      found.fuses ? "fused" : "rounded twice", kept(found.keeps_small_operands),
                      kept(found.keeps_small_results), device::against_usual(found)),
          ""};
}

}  // namespace shadefit
