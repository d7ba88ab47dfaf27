#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "bench/device/times/device_forms.hpp"
#include "bench/device/vulkan_device.hpp"

namespace shadefit::device {

/// How to open the device at a place for the values of these forms: its buffers are readable from here.
DeviceChoice choice_for_values(std::size_t place, const DeviceForms& forms);

/// The largest absolute error of each form on a device, in one precision. Empty if the target has no truth.
std::vector<std::optional<double>> errors_on_device(VulkanDevice& device, const DeviceForms& forms,
                                                    ShaderPrecision precision,
                                                    const std::function<void()>& between);

}  // namespace shadefit::device
