#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "bench/device/device_clock.hpp"
#include "bench/device/spirv.hpp"
#include "bench/device/times/timing_shader.hpp"
#include "bench/device/vulkan_device.hpp"
#include "bench/timing/timing.hpp"

/// The dispatches that are timed on a device.
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

inline constexpr std::array chains{Chain::independent, Chain::dependent};

/// The places of a function's dispatches among all: by chain.
using Slots = std::array<std::size_t, chains.size()>;

/// Dispatches with as many turns as the plan's seconds need, visited in interleaved rounds. First are the
/// copy of words and the empty kernel. The device must outlive it.
class Programme {
 public:
  /// `between` may end the preparation by throwing; so may that of `run`.
  Programme(VulkanDevice& device, const DevicePlan& plan, std::function<void()> between);
  Programme(const Programme&) = delete;
  Programme& operator=(const Programme&) = delete;

  static constexpr std::size_t copy = 0, empty = 1;

  /// A function whose arguments lie in these ranges.
  Slots add(const ShaderFunction& function, std::span<const Range> ranges, ShaderPrecision precision);

  /// The elements of a dispatch: words of the copy, the one empty kernel, evaluations.
  std::size_t elements(std::size_t slot) const { return work_.at(slot).elements; }

  /// The times of all, in ns per element.
  std::vector<bench::Samples> run(const std::function<void(double)>& between) const;

 private:
  struct Timed;
  Timed timed(const std::string& shader, ShaderPrecision precision);
  void add(const Timed& shader);
  void add_copy();
  void add_empty();

  VulkanDevice& device_;
  ShaderCompiler compiler_;
  DevicePlan plan_;
  std::function<void()> between_;
  std::uint32_t threads_;
  std::vector<bench::Work> work_;
  double seconds_ = 0;  ///< the clock: the seconds of all dispatches so far
};

}  // namespace shadefit::device
