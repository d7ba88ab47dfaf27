#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "bench/device/evaluating_shader.hpp"
#include "bench/device/vulkan_device.hpp"
#include "reports/code/shader_code.hpp"

/// A function that is evaluated on a device.
namespace shadefit::device {

/// A function as `emit` writes it, ready on a device, which must outlive it. In half, which only GLSL can be,
/// each operation is one of 16 bits: see `with_halves`.
class Evaluator {
 public:
  Evaluator(VulkanDevice& device, const ShaderCompiler& compiler, const ShaderFunction& function,
            ShaderLanguage language, Arguments arguments,
            ShaderPrecision precision = ShaderPrecision::float32);

  /// Calls `take` with the results for some bit patterns after the others, of [from, to): the first of them,
  /// and a result for each. The dispatches are short.
  void over_patterns(std::uint32_t from, std::uint32_t to,
                     const std::function<void(std::uint32_t, std::span<const std::uint32_t>)>& take);

  /// The results for arguments, one after the other. The span is valid until the next call.
  std::span<const std::uint32_t> of_input(std::span<const float> arguments);

 private:
  VulkanDevice& device_;
  Program program_;
  std::size_t argument_count_;
};

}  // namespace shadefit::device
