#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "bench/device/vulkan_device.hpp"
#include "bench/forms/float_errors.hpp"
#include "fit/scalars/gpu_model.hpp"
#include "reports/code/shader_code.hpp"

/// Evaluates a form at every float on a device.
namespace shadefit::device {

/// A device, and the results of the form that ran last on it.
struct SweptDevice {
  explicit SweptDevice(VulkanDevice made) : vulkan(std::move(made)) {}

  VulkanDevice vulkan;
  std::uint32_t first = 0;  ///< the bit pattern that the first result belongs to
  std::vector<std::uint32_t> results = {};
};

/// Replaces the form of a subject by one on a device, and adds the bound that follows from the errors of the
/// device's functions. The subject's floats lie in [0, 1]. Several forms may share a device, if each is
/// prepared and looked at before the next.
void sweep_on_device(bench::FloatSubject& subject, std::shared_ptr<SweptDevice> device,
                     const ShaderFunction& form, const GpuModel& model);

}  // namespace shadefit::device
