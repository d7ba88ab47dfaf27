
#include "bench/device/spirv.hpp"
#include "bench/device/vulkan_device.hpp"
#include "fit/support/user_error.hpp"

/// The functions of a device in a build without Vulkan: each says what to install.
namespace shadefit::device {
namespace {

[[noreturn]] void refuse() {
  throw UserError(
      "'--device vulkan' is not in this build: install libvulkan-dev and glslang-dev, then build shadefit again");
}

}  // namespace

struct VulkanDevice::Parts {};

std::vector<DeviceInfo> vulkan_devices() {
  refuse();
}
VulkanDevice::VulkanDevice(const DeviceChoice&) {
  refuse();
}
VulkanDevice::~VulkanDevice() = default;
VulkanDevice::VulkanDevice(VulkanDevice&&) noexcept = default;
VulkanDevice& VulkanDevice::operator=(VulkanDevice&&) noexcept = default;
const DeviceInfo& VulkanDevice::info() const {
  refuse();
}
Program VulkanDevice::load(std::span<const std::uint32_t>) const {
  refuse();
}
double VulkanDevice::run(const Program&, std::uint32_t, const PushWords&) {
  refuse();
}
std::span<std::uint32_t> VulkanDevice::output() {
  refuse();
}
std::span<std::uint32_t> VulkanDevice::input() {
  refuse();
}
const std::vector<std::string>& VulkanDevice::messages() const {
  refuse();
}

ShaderCompiler::ShaderCompiler() {
  refuse();
}
ShaderCompiler::~ShaderCompiler() = default;
std::vector<std::uint32_t> ShaderCompiler::spirv(const std::string&, ShaderLanguage, ShaderPrecision) const {
  refuse();
}

}  // namespace shadefit::device
