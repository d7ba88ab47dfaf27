#include <string>

#include "app/device/device_commands.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

[[noreturn]] void refuse(const std::string& option) {
  throw UserError(
      option +
      " is not in this build: install libvulkan-dev, glslang-dev, glslang-tools and spirv-tools, and "
      "build shadefit with -D SHADEFIT_DEVICE=ON");
}

}  // namespace

Outcome list_devices_command(const BenchOptions&) {
  refuse("--list-devices");
}

bench::Trade trade_on_device(const BenchOptions&, const std::function<bench::Trade()>&, const Watched&) {
  refuse("--device");
}

Sweeper sweeper_on_device(const BenchOptions&) {
  refuse("--device");
}

}  // namespace shadefit
