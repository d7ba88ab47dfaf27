#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fit/scalars/symbolic.hpp"

/// Calls of functions as GLSL, HLSL and C write them, expressed in the vocabulary: `clamp(x, a, b)` is
/// `min(max(x, a), b)`, `cosf` is `cos`, `fabs` is `abs`, `atan(y, x)` is `atan2(y, x)`. Definitions:
/// Khronos, "The OpenGL Shading Language 4.60", chapter 8. `mod` rounds the quotient down, `fmod` rounds it
/// towards zero, as C does.
namespace shadefit {

/// The names of all functions, without the suffix f of C.
std::vector<std::string> function_names();

/// The numbers of arguments that a function takes, in rising order; empty if there is no such function.
std::vector<std::size_t> argument_counts(std::string_view function);

/// The expression of a call with one of these numbers of arguments.
Symbolic call(std::string_view function, std::span<const Symbolic> arguments);

/// base^exponent: by multiplications if the exponent is written as a whole number (5, -2, 4.0), else a real
/// power.
Symbolic raised(const Symbolic& base, const Symbolic& exponent);

}  // namespace shadefit
