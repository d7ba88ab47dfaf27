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

/// The arguments of dot(u, vec3(a, b, c)) as a sum over the components of u by name. Empty without such a
/// vector.
std::optional<std::string> dot_product(std::string_view arguments);

}  // namespace shadefit::lint
