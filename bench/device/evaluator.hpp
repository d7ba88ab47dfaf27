#pragma once

#include <cstddef>
#include <span>

#include "bench/device/spirv.hpp"
#include "bench/device/vulkan_device.hpp"

/// A function that is evaluated on a device.
namespace shadefit::device {

/// A function as `emit` writes it, loaded on a device. The device must outlive it. In half, which only GLSL
/// has, each operation has 16 bits: see `ShaderCompiler::spirv`.
class Evaluator {
 public:
  Evaluator(VulkanDevice& device, const ShaderCompiler& compiler, const ShaderFunction& function,
            ShaderPrecision precision = ShaderPrecision::float32, Language language = Language::glsl);

  /// The results for a list of arguments: those of the first evaluation, then those of the second, and so on.
  /// The span is valid until the next call.
  std::span<const float> of(std::span<const float> arguments);

 private:
  VulkanDevice& device_;
  Program program_;
  std::size_t argument_count_;
};

}  // namespace shadefit::device
