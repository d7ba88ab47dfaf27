#pragma once

#include <functional>
#include <string>

#include "bench/device/vulkan_device.hpp"

/// The clock that times dispatches.
namespace shadefit::device {

/// Whether a device is a driver that runs on the CPU.
bool is_the_cpu(const DeviceInfo& info);

/// In words: "timestamps of the device".
std::string name_of_clock(const DeviceInfo& info);

/// The seconds of a dispatch, which returns those of `VulkanDevice::run`. A device that is the CPU shares its
/// cores with other programs: its time is the processor time of this process, all threads together, as if
/// each core worked for it alone from begin to end. A coarse clock may say 0, with which no number of
/// dispatches would be enough: none takes less than a microsecond.
double seconds_of_dispatch(const DeviceInfo& info, const std::function<double()>& dispatch);

}  // namespace shadefit::device
