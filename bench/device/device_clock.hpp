#pragma once

#include <functional>
#include <string>

#include "bench/device/vulkan_device.hpp"

/// The clock that times dispatches.
namespace shadefit::device {

/// Whether the driver of a device runs on the CPU.
bool is_the_cpu(const DeviceInfo& info);

/// In words: "timestamps of the device".
std::string name_of_clock(const DeviceInfo& info);

/// The seconds of one dispatch. `dispatch` runs it and returns the seconds of `VulkanDevice::run`. Other
/// programs share the cores of a device that is the CPU, so its time is the processor time of all threads of
/// this process, divided by the number of cores. The result is at least a microsecond: a coarse clock may say
/// 0, and then no number of dispatches would take long enough.
double seconds_of_dispatch(const DeviceInfo& info, const std::function<double()>& dispatch);

}  // namespace shadefit::device
