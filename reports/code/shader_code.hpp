#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fit/scalars/symbolic.hpp"

/// Functions for shaders and for C, generated from their formulas.
namespace shadefit {

enum class Language { glsl, hlsl, c, cpp, wgsl, msl };

inline constexpr std::array languages{Language::glsl, Language::hlsl, Language::c,
                                      Language::cpp,  Language::wgsl, Language::msl};

/// As it is asked for: "glsl" ..
std::string_view name(Language language);

/// The arithmetic of generated code.
enum class ShaderPrecision { float32, float16 };

inline constexpr std::array shader_precisions{ShaderPrecision::float32, ShaderPrecision::float16};

/// "float" or "half".
std::string_view name(ShaderPrecision precision);

/// The first line of generated code: so it is recognised.
inline constexpr std::string_view generated_line =
    "Generated: do not edit. Made by the next line, held against it by 'shadefit emit --check FILE'.";

/// What is generated: a function of numbers to a number.
struct ShaderFunction {
  std::string name;                    ///< letters, digits and `_`
  std::vector<std::string> arguments;  ///< the variables of `result`, in their order
  Symbolic result;
  std::vector<std::string> comment = {};  ///< lines above it
};

/// An expression as generated code has it: every part that is of numbers alone is one number, computed in 50
/// digits and rounded once to the format, as the shortest decimal that reads back as it; a whole power is its
/// multiplications, in the order of `power`; exp of a number times something is exp2 of another.
///
/// Evaluated in float, operation by operation, it is bit for bit what the code computes, where that is
/// compiled without contraction and calls the same exp2.
Symbolic as_generated(const Symbolic& expression, ShaderPrecision precision);

/// The functions in a language, below `comment`. What several operations use is computed once. A file of it
/// needs nothing else: C and C++ include <math.h> or <cmath>, Metal its own library.
///
/// Throws UserError where a language lacks what is asked: a function of the vocabulary (log1p in a shader),
/// or half in C and C++.
std::string shader_code(std::span<const ShaderFunction> functions, Language language,
                        ShaderPrecision precision, std::span<const std::string> comment);

}  // namespace shadefit
