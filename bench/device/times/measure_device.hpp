#pragma once

#include <cstdint>
#include <functional>

#include "bench/device/times/device_forms.hpp"
#include "bench/device/vulkan_device.hpp"
#include "bench/timing/timing.hpp"
#include "bench/tradeoff/trade.hpp"

/// Times and errors of forms on a device.
namespace shadefit::device {

struct DevicePlan {
  bench::TimingPlan timing;    ///< its seconds are those that a dispatch should take at least
  std::uint32_t copied_words;  ///< words of the copy: more than a device's caches hold, where time allows it
};

/// Of a whole bench and of a quick one. Where the device is the CPU, other programs disturb some dispatches:
/// many short ones have a better median than few long ones. A copy writes 64 MiB: the last cache of a large
/// GPU has 50 MiB.
inline constexpr DevicePlan full_device_plan{{41, 2e-3}, 1U << 24}, quick_device_plan{{9, 1e-3}, 1U << 20};

/// The least number of turns, by powers of two, with which a dispatch takes at least `seconds`; or `most`.
/// `run` dispatches that many turns and returns its seconds. From one turn on their number is doubled: no
/// dispatch takes much longer than twice `seconds`, or than one turn.
std::uint32_t turns_that_take(double seconds, std::uint32_t most,
                              const std::function<double(std::uint32_t)>& run);

/// The largest |value - truth|, or infinity if a value is no number.
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
