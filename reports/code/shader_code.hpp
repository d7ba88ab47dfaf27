#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fit/scalars/symbolic.hpp"

/// Functions for shaders, kernels and C, generated from their formulas.
namespace shadefit {

enum class Language { glsl, hlsl, c, cpp, wgsl, msl, cuda, opencl };

inline constexpr std::array languages{Language::glsl, Language::hlsl, Language::c,    Language::cpp,
                                      Language::wgsl, Language::msl,  Language::cuda, Language::opencl};

/// The name of the option value: "glsl" ..
std::string_view name(Language language);

/// The arithmetic of generated code.
enum class ShaderPrecision { float32, float16 };

inline constexpr std::array shader_precisions{ShaderPrecision::float32, ShaderPrecision::float16};

/// "float" or "half".
std::string_view name(ShaderPrecision precision);

/// The first line of generated code, by which it is recognised.
inline constexpr std::string_view generated_line =
    "Generated: do not edit. Made by the next line, held against it by 'shadefit emit --check FILE'.";

/// A generated function of numbers that returns a number.
struct ShaderFunction {
  std::string name;                    ///< letters, digits and `_`
  std::vector<std::string> arguments;  ///< the variables of `result`, in their order
  Symbolic result;
  std::vector<std::string> comment = {};  ///< lines above it
};

/// An expression as in generated code. Each part of numbers alone becomes one number, computed in 50 digits,
/// rounded once to the format and written as the shortest decimal that reads back. A whole power becomes
/// multiplications in the order of `power`. exp of a number times an expression becomes exp2.
///
/// Evaluated in float, operation by operation, it equals the result of the code bit for bit, if the code is
/// compiled without contraction and calls the same exp2.
Symbolic as_generated(const Symbolic& expression, ShaderPrecision precision);

/// The functions in a language, below `comment`. Common subexpressions are computed once. The file is
/// complete: C and C++ include <math.h> or <cmath>, Metal its own library. C, C++, CUDA and OpenCL C have an
/// include guard.
///
/// Throws UserError if the language lacks a function of the vocabulary (log1p in a shader, acos of half in
/// CUDA), or half (C and C++).
std::string shader_code(std::span<const ShaderFunction> functions, Language language,
                        ShaderPrecision precision, std::span<const std::string> comment);

}  // namespace shadefit
