#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "bench/device/vulkan_device.hpp"

/// How dispatches are divided and timed.
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

/// The longest time of a dispatch in seconds. Drivers stop one that takes seconds; a desktop stutters
/// earlier.
inline constexpr double longest_dispatch = 0.2;

/// Runs `count` items in dispatches of at most `most` items, each well below `longest_dispatch`. The first is
/// small; the times so far give the size of the next. `run` dispatches [from, from + n) and returns its
/// seconds.
void in_short_dispatches(std::uint64_t count, std::uint64_t most,
                         const std::function<double(std::uint64_t from, std::uint64_t n)>& run);

}  // namespace shadefit::device
