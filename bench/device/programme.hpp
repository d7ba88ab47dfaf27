#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "bench/device/dispatches.hpp"
#include "bench/device/spirv.hpp"
#include "bench/device/timing_shader.hpp"
#include "bench/device/vulkan_device.hpp"
#include "bench/tradeoff/timing.hpp"

/// The dispatches that are timed on a device.
namespace shadefit::device {

/// The plans of a whole bench and of a quick one; the seconds are the least time of a dispatch. If the device
/// is the CPU, other programs disturb some dispatches: many short ones have a better median than few long
/// ones.
inline constexpr bench::TimingPlan full_device_plan{41, 2e-3}, quick_device_plan{9, 1e-3};

/// Times in ns, one for each round.
using Rounds = std::vector<double>;

/// Dispatches with as many turns as the plan's seconds need, visited in interleaved rounds. The first is the
/// empty kernel. The device must outlive it.
class Programme {
 public:
  explicit Programme(VulkanDevice& device);
  Programme(const Programme&) = delete;
  Programme& operator=(const Programme&) = delete;

  /// Adds a function whose arguments lie in these ranges. Returns its slot.
  std::size_t add(const ShaderFunction& function, std::span<const bench::Range> ranges,
                  ShaderPrecision precision);

  /// By slot the time of an evaluation in ns, one for each round, less the median time of the empty kernel.
  /// The first is that of an empty dispatch. `between` may throw.
  std::vector<Rounds> run(const bench::TimingPlan& plan, const std::function<void(double)>& between) const;

 private:
  Program load(const ShaderFunction& function, std::span<const bench::Range> ranges,
               ShaderPrecision precision) const;
  /// Dispatches a shader with so many turns, and returns the seconds.
  double seconds_of(const Program& program, long turns) const;

  VulkanDevice& device_;
  ShaderCompiler compiler_;
  std::uint32_t threads_;
  std::vector<bench::Work> work_;
};

}  // namespace shadefit::device
