#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "bench/device/spirv.hpp"
#include "bench/device/vulkan_device.hpp"
#include "reports/code/shader_code.hpp"

/// A function that is evaluated on a device.
namespace shadefit::device {

/// Where the arguments of a function come from.
enum class Arguments {
  patterns,  ///< thread i has one argument: the float with bit pattern i + the first push word
  input,     ///< thread t reads n arguments from word n i of the input on; i = t + the first push word
};

/// A function as `emit` writes it, loaded on a device. The device must outlive it. In half, which only GLSL
/// has, each operation has 16 bits: see `ShaderCompiler::spirv`.
class Evaluator {
 public:
  Evaluator(VulkanDevice& device, const ShaderCompiler& compiler, const ShaderFunction& function,
            ShaderLanguage language, Arguments arguments,
            ShaderPrecision precision = ShaderPrecision::float32);

  /// Evaluates the function at all bit patterns of [from, to), in short dispatches. After each dispatch
  /// `take` gets the first bit pattern and the results from there on.
  void over_patterns(std::uint32_t from, std::uint32_t to,
                     const std::function<void(std::uint32_t, std::span<const std::uint32_t>)>& take);

  /// The results for a list of arguments: those of the first evaluation, then those of the second, and so on.
  /// The span is valid until the next call.
  std::span<const std::uint32_t> of_input(std::span<const float> arguments);

 private:
  VulkanDevice& device_;
  Program program_;
  std::size_t argument_count_;
};

}  // namespace shadefit::device
