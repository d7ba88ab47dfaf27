#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/device/vulkan_device.hpp"
#include "bench/forms/forms.hpp"
#include "fit/scalars/gpu_model.hpp"
#include "fit/support/checkpoint.hpp"

/// Measures the errors of a device's functions.
namespace shadefit::device {

/// The largest error of a function, and where.
struct LargestError {
  double error = 0;  ///< infinite if a result was NaN
  std::vector<float> at = {};
  std::uint64_t count = 0;  ///< how many arguments were tried
};

/// Errors are |result - truth| divided by the ulp of the truth: 2^(e - 23), where 2^e is the largest power of
/// two that is not above it.
struct Probe {
  LargestError exp2;           ///< in ulps, floats from -126 to 128: all normal results
  LargestError log2;           ///< in ulps, normal floats outside of [1/2, 2]
  LargestError log2_near_one;  ///< absolute, floats inside
  LargestError root;           ///< in ulps, normal floats
  LargestError reciprocal;     ///< in ulps, likewise, where the result is normal
  LargestError quotient;       ///< in ulps, random pairs
  LargestError power;          ///< in ulps, random pairs x^y: x in [1/256, 1], y in [1, 64], normal results
  bool fuses = false;          ///< a b + c is rounded once
  bool keeps_small_operands = false,
       keeps_small_results = false;  ///< subnormal numbers; false: they become 0
};

enum class ProbeExtent {
  all,     ///< every float
  sample,  ///< 1 % of them, of all exponents
};

/// Measures a device. The truth is that of the C library in double, whose error is below 1e-8 ulps of a
/// float. `checkpoint` is called several times a second.
Probe probe(VulkanDevice& device, ProbeExtent extent, const Checkpoint& checkpoint = keep_going);

/// Errors are |result - truth|, in ulps of a half at the truth: 2^(e - 10), where 2^e is the largest power of
/// two that is not above it. One half is rounding, up to 1 is cutting off.
struct HalfProbe {
  LargestError exp2;           ///< in ulps, from -14 up to 16: all normal results
  LargestError log2;           ///< in ulps, normal halves outside of [1/2, 2]
  LargestError log2_near_one;  ///< absolute, halves inside
  LargestError root;           ///< in ulps, normal halves
  LargestError reciprocal;     ///< in ulps, likewise, where the result is normal
};

/// Measures the functions of a device in half, at every half. Throws UserError if the device has no half.
HalfProbe probe_halves(VulkanDevice& device);

/// In a line: whether exp2 and log2 are as exact as `usual_gpu` assumes, or coarser.
std::string against_usual(const Probe& found);

/// The error model for forms with this function. Only what they need is measured; the rest is `usual_gpu`.
GpuModel model_for(forms::Function function, VulkanDevice& device, const Checkpoint& checkpoint = keep_going);

}  // namespace shadefit::device
