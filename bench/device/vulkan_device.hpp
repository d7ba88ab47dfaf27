#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

/// Compute shaders on the graphics devices of this machine, by Vulkan.
///
/// The Vulkan loader is opened while the program runs. Where it is missing, each function says so in one line
/// (UserError).
namespace shadefit::device {

/// What is known of a device before anything runs on it.
struct DeviceInfo {
  std::string name;             ///< "llvmpipe (LLVM 15.0.6, 256 bits)"
  std::string driver;           ///< name and version of the driver, as it names itself
  std::string vulkan;           ///< the version of Vulkan: "1.3.230"
  std::string kind;             ///< "discrete GPU", "integrated GPU", "virtual GPU", "CPU" or "other"
  bool has_half = false;        ///< shaderFloat16: arithmetic of 16 bits
  bool has_timestamps = false;  ///< a clock of its own; otherwise a dispatch is timed from outside
};

/// The devices that can run compute shaders, in the order of the Vulkan loader. May be empty.
std::vector<DeviceInfo> vulkan_devices();

/// The local size in x of every shader, and the most threads of a dispatch: every driver allows 65535 groups.
inline constexpr std::uint32_t threads_per_group = 64, most_threads = 65535 * threads_per_group;

/// The two words that a dispatch gives its shader.
using PushWords = std::array<std::uint32_t, 2>;

/// Which device, and how it is used.
struct DeviceChoice {
  std::size_t place = 0;               ///< in `vulkan_devices`
  std::size_t words = 1U << 22;        ///< size of each buffer in floats
  bool has_buffers_on_device = false;  ///< in the device's own memory, which this program cannot read
};

/// A shader that is ready to run. It must not outlive its device.
struct Program {
  struct Parts;
  std::shared_ptr<const Parts> parts;
};

/// A device with two storage buffers of floats: binding 0 is the output, binding 1 the input. Every function
/// throws CheckFailed with one line if the device is lost, is out of memory or does not answer.
class VulkanDevice {
 public:
  /// Throws UserError if `vulkan_devices` has no entry at `choice.place`.
  explicit VulkanDevice(const DeviceChoice& choice);
  ~VulkanDevice();

  const DeviceInfo& info() const;

  /// A compute shader as SPIR-V, with the entry point `main`.
  Program load(std::span<const std::uint32_t> spirv) const;

  /// Runs `threads` threads, rounded up to whole groups, and waits. Returns the seconds that they took.
  double run(const Program& program, std::uint32_t threads, const PushWords& push);

  /// The buffers, or empty if this program cannot read them.
  std::span<float> output();
  std::span<float> input();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace shadefit::device
