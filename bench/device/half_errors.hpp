#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "bench/device/vulkan_device.hpp"
#include "fit/scalars/gpu_model.hpp"
#include "reports/code/shader_code.hpp"

/// Every half through a form on a device.
namespace shadefit::device {

/// The errors at every half in [0, 1]. Of equal maxima the first half is kept.
struct HalfErrors {
  std::size_t count = 0;
  double max_abs_error = 0;  ///< |form - truth|
  double max_abs_error_at = 0;
  std::uint32_t max_ulps = 0;  ///< halves between the form and the truth rounded to half
  double max_ulps_at = 0;
  std::array<std::uint64_t, 17> ulps = {};  ///< [0]: none; [i]: 2^(i-1) to 2^i - 1
  std::size_t nans = 0;
  std::size_t unbounded = 0;        ///< where the bound is infinite, as that of log2 at 0
  std::vector<double> beyond = {};  ///< where the form is farther from its real value than its bound
};

/// The truth for `count` cosines, a multiple of 64.
using TruthOfCosines = std::function<void(const float* in, double* out, std::size_t count)>;

/// Throws UserError if the device has no half.
void require_half(const DeviceInfo& info);

/// A function of one cosine, each operation in 16 bits: see `ShaderCompiler::spirv`. The bound takes the
/// device's functions as errors of floats that are rounded to half or cut off. Throws UserError if the device
/// has no half.
HalfErrors errors_in_half(VulkanDevice& device, const ShaderFunction& function, const TruthOfCosines& truth,
                          const GpuModel& model);

}  // namespace shadefit::device
