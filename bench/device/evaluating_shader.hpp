#pragma once

#include <string>

#include "bench/device/spirv.hpp"
#include "reports/code/shader_code.hpp"

/// A compute shader that evaluates a function.
namespace shadefit::device {

/// Where the arguments of a function come from.
enum class Arguments {
  patterns,  ///< thread i has the one argument whose bit pattern is i + the first push word
  input,     ///< the n arguments of place i, i the thread + the first push word, lie in the input from n i on
};

/// The code that `emit` writes for a function, and a main function that calls it once a thread. The threads
/// below the second push word write their result: thread i to word i of the output, or to that of its place.
std::string evaluating_shader(const ShaderFunction& function, ShaderLanguage language, Arguments arguments,
                              ShaderPrecision precision = ShaderPrecision::float32);

}  // namespace shadefit::device
