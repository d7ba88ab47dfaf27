#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/device/vulkan_device.hpp"
#include "bench/forms/forms.hpp"
#include "fit/scalars/gpu_model.hpp"
#include "fit/support/checkpoint.hpp"

/// What a device's functions really do.
namespace shadefit::device {

/// The largest error of a function, and where.
struct LargestError {
  double error = 0;  ///< infinite if a result was NaN
  std::vector<float> at = {};
  std::uint64_t count = 0;  ///< how many arguments were tried
};

/// Errors are real-valued: |result - truth| by the ulp of the truth, 2^(e - 23) where 2^e is the largest
/// power of two that is not above it.
struct Probe {
  LargestError exp2;           ///< in ulps, every float from -126 to 128: all normal results
  LargestError log2;           ///< in ulps, every normal float outside of [1/2, 2]
  LargestError log2_near_one;  ///< absolute, every float inside
  LargestError root;           ///< in ulps, floats of all exponents
  LargestError reciprocal;     ///< in ulps, likewise, where the result is normal
  LargestError quotient;       ///< in ulps, drawn pairs
  LargestError power;          ///< in ulps, drawn pairs x^y: x in [1/256, 1], y in [1, 64], normal results
  bool fuses = false;          ///< a b + c is rounded once
  bool keeps_small_operands = false, keeps_small_results = false;  ///< subnormal ones, else they become 0
};

enum class ProbeExtent {
  all,     ///< every float, also for the root and the reciprocal
  sample,  ///< every float for exp2 and log2; a hundredth of the others
};

/// Measures a device. The truth is that of the C library in double, whose error is below 1e-8 ulps of a
/// float. `checkpoint` is called some times a second.
Probe probe(VulkanDevice& device, ProbeExtent extent, const Checkpoint& checkpoint = keep_going);

/// The device as a model for bounds. Quotients and roots are sampled: they have no less than `usual_gpu`.
GpuModel model_of(const Probe& probe);

/// The model for forms with such a function. Only what they need is measured, the rest is as in `usual_gpu`.
GpuModel model_for(forms::Function function, VulkanDevice& device, const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit::device
