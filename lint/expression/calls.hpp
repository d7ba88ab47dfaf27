#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Names and calls in programs, in any language, in the notation of formulas.
namespace shadefit::lint {

/// Whether the word is a type whose constructor keeps its one number: vec3, f32, Vec3.
bool is_number_type(std::string_view word);

/// The usual name of a function: clamp for Clamp, pow for powr, sqrt for XeGTAO_FastSqrt.
std::string usual_name(std::string_view word);

/// A multiple of pi in the notation of formulas: "(pi/2)" for HALF_PI. Empty for other names.
std::optional<std::string> pi_in(std::string_view path);

/// The arguments of a call, without the blanks around.
std::vector<std::string_view> arguments_in(std::string_view list);

/// " * " for mul; empty for words other than add, sub, mul and div.
std::string_view operator_of(std::string_view word);

/// A call that compares, selects or multiplies vectors, as a formula: lessThan(a, b) is 1 or 0, as a mask for
/// mix(); select(x < t, a, b) is x < t ? a : b, and so is select(b, a, x < t) of WGSL; dot(u, vec3(a, b, c))
/// is a sum over the components of u by name; __fmul_rn(a, b) of CUDA is a product. Empty for other calls.
std::optional<std::string> call_as_formula(std::string_view function, std::string_view arguments);

}  // namespace shadefit::lint
