#pragma once

#include <functional>

#include "bench/device/times/device_forms.hpp"
#include "bench/device/times/programme.hpp"
#include "bench/device/vulkan_device.hpp"
#include "bench/tradeoff/trade.hpp"

/// Times and errors of forms on a device.
namespace shadefit::device {

/// The largest |value - truth|; infinity if a value is NaN.
double largest_error(std::span<const float> values, std::span<const double> truth);

/// How the device at a place is opened for its times: with buffers in its own memory.
DeviceChoice choice_for_times(std::size_t place, const DevicePlan& plan);

/// Measures forms on a device, in float, and in half where it has it. The device is opened twice: by
/// `choice_for_times`, and by `choice_for_values` for the errors.
///
/// The time of a form is that of a turn of its shader, divided by the evaluations, less the chain's own: the
/// time of the shader whose function returns its argument, and a multiply-add for each argument but the
/// first. The time of a multiply-add is that of `multiply_add_chain` by the same rule, divided by their
/// number. All are visited once a round, and the difference is taken within each. The empty kernel's median,
/// of a dispatch of no turns, is subtracted from every dispatch.
///
/// `copies` of the trade has the floors: the copy of a word, the empty dispatch, a multiply-add.
bench::Trade measure_on_device(VulkanDevice& for_times, VulkanDevice& for_values, const DeviceForms& forms,
                               const DevicePlan& plan, const std::function<void(double)>& between);

}  // namespace shadefit::device
