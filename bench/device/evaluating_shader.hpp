#pragma once

#include <string>

#include "bench/device/spirv.hpp"
#include "reports/code/shader_code.hpp"

/// A compute shader that evaluates a function.
namespace shadefit::device {

/// Where the arguments of a function come from.
enum class Arguments {
  patterns,  ///< thread i has one argument: the float with bit pattern i + the first push word
  input,     ///< thread t reads n arguments from word n i of the input on; i = t + the first push word
};

/// The code that `emit` writes for a function, and a main function that calls it once per thread. The threads
/// below the second push word write their result: with `patterns` thread i writes word i of the output, with
/// `input` it writes word i + the first push word.
std::string evaluating_shader(const ShaderFunction& function, ShaderLanguage language, Arguments arguments,
                              ShaderPrecision precision = ShaderPrecision::float32);

}  // namespace shadefit::device
