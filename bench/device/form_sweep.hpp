#pragma once

#include "bench/device/vulkan_device.hpp"
#include "bench/forms/float_errors.hpp"
#include "fit/scalars/gpu_model.hpp"
#include "reports/code/shader_code.hpp"

/// Evaluates a form at every float on a device.
namespace shadefit::device {

/// Replaces the form of a subject by one on a device, and adds the bound of its results. The subject's floats
/// lie in [0, 1]. The device must outlive it.
void sweep_on_device(bench::FloatSubject& subject, VulkanDevice& device, const ShaderFunction& form,
                     const GpuModel& model);

}  // namespace shadefit::device
