#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fit/scalars/symbolic.hpp"

/// Calls of functions as GLSL, HLSL and C write them, expressed in the vocabulary: `clamp(x, a, b)` is
/// `min(max(x, a), b)`, `cosf` and `arccos` are `cos` and `acos`, `fabs` is `abs`, `atan(y, x)` is `atan2(y,
/// x)`. Definitions: Khronos, "The OpenGL Shading Language 4.60", chapter 8. `mod` rounds the quotient down,
/// `fmod` rounds it towards zero, as C does. `round` takes halves away from zero, as C does; GLSL leaves them
/// open, and HLSL takes the even number.
namespace shadefit {

/// The names of all functions, without the suffix f of C.
std::vector<std::string> function_names();

/// pi, ln2, and the names that shaders and C's math.h have for constants, such as M_PI_2; empty for any other
/// name.
std::optional<Symbolic> named_constant(std::string_view name);

/// Whether a name is a type of vectors or matrices, such as vec3, half4 or float3x3, or a function that only
/// vectors have. They are not part of the language, and are refused by name.
bool is_of_vectors(std::string_view name);

/// The types that a cast to a real number names: `(float)x` is x.
bool is_real_type(std::string_view name);

/// Whether a name is a module of Python whose functions are read: np, numpy or math.
bool is_python_module(std::string_view name);

/// Our name for a name of these modules: `clip` is clamp, `e` is M_E. Any other is itself.
std::string_view name_for_numpy(std::string_view name);

/// The numbers of arguments that a function takes, in rising order; empty if there is no such function.
std::vector<std::size_t> argument_counts(std::string_view function);

/// The expression of a call with one of these numbers of arguments.
Symbolic call(std::string_view function, std::span<const Symbolic> arguments);

/// base^exponent: by multiplications if the exponent is written as a whole number (5, -2, 4.0), else a real
/// power.
Symbolic raised(const Symbolic& base, const Symbolic& exponent);

}  // namespace shadefit
