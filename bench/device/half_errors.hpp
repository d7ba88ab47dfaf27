#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "bench/device/vulkan_device.hpp"
#include "bench/forms/float_errors.hpp"
#include "fit/scalars/gpu_model.hpp"
#include "reports/code/shader_code.hpp"

/// Every half through a form on a device.
namespace shadefit::device {

/// The truth for `count` cosines.
using TruthOfCosines = std::function<void(const float* in, double* out, std::size_t count)>;

/// Throws UserError if the device has no half.
void require_half(const DeviceInfo& info);

/// A function of one cosine at every half in [0, 1], each operation in 16 bits: see `ShaderCompiler::spirv`.
/// Where the bound is infinite, as that of log2 at 0, the result counts as unbounded. The bound takes the
/// device's functions as errors of floats that are rounded to half or cut off. Throws UserError if the device
/// has no half.
bench::FloatErrors errors_in_half(VulkanDevice& device, const ShaderFunction& function,
                                  const TruthOfCosines& truth, const GpuModel& model);

}  // namespace shadefit::device
