#pragma once

#include "bench/device/probe.hpp"
#include "bench/device/vulkan_device.hpp"

/// Measures the functions of a device in half, at every half.
namespace shadefit::device {

/// Errors are |result - truth|, in ulps of a half at the truth: 2^(e - 10), where 2^e is the largest power of
/// two that is not above it. One half is rounding, up to 1 is cutting off.
struct HalfProbe {
  LargestError exp2;           ///< in ulps, from -14 up to 16: all normal results
  LargestError log2;           ///< in ulps, normal halves outside of [1/2, 2]
  LargestError log2_near_one;  ///< absolute, halves inside
  LargestError root;           ///< in ulps, normal halves
  LargestError reciprocal;     ///< in ulps, likewise, where the result is normal
};

/// Throws UserError if the device has no half.
HalfProbe probe_halves(VulkanDevice& device);

}  // namespace shadefit::device
