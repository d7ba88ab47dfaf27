#pragma once

#include <string>

#include "bench/device/spirv.hpp"
#include "reports/code/shader_code.hpp"

/// A compute shader that evaluates a function.
namespace shadefit::device {

/// The code that `emit` writes for a function, and a main function that calls it once a thread. The thread i
/// of those below the second push word writes the float f to word i of the output:
/// - a function of one argument is called with the float of the bit pattern i + the first push word;
/// - one of more arguments with floats of the input: its arguments for thread i lie from word i n on.
std::string evaluating_shader(const ShaderFunction& function, ShaderLanguage language);

}  // namespace shadefit::device
