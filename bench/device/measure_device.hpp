#pragma once

#include <functional>

#include "bench/device/programme.hpp"
#include "bench/device/vulkan_device.hpp"
#include "bench/tradeoff/timed_forms.hpp"

/// Times and errors of forms on a device.
namespace shadefit::device {

/// Measures the forms of a trade on a device: in float, and in half if the device has it. The device is
/// opened twice: with buffers in its own memory for times, and with readable ones for errors.
///
/// The time of a form is that of one turn of its shader, divided by the evaluations of a turn, less the time
/// of the chain: that of the shader whose function returns its argument, and a multiply-add for each argument
/// after the first. The time of a multiply-add comes from `multiply_add_chain` by the same rule, divided by
/// their number. Each round visits all shaders, and differences are taken within a round. The median time of
/// the empty kernel, a dispatch of no turns, is subtracted from every dispatch.
///
/// The first forms of the trade, without a target, are the empty dispatch and a multiply-add. Throws
/// CheckFailed if the median time of a multiply-add is not above 0.
bench::Trade measure_on_device(VulkanDevice& for_times, VulkanDevice& for_values, bench::Trade trade,
                               const bench::TimingPlan& plan, const std::function<void(double)>& between);

}  // namespace shadefit::device
