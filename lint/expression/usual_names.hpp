#pragma once

#include <optional>
#include <string>
#include <string_view>

/// The meaning of common names in programs, in any language.
namespace shadefit::lint {

/// Whether the word is a type whose constructor keeps its one number: vec3, f32, Vec3.
bool is_number_type(std::string_view word);

/// The usual name of a function: clamp for Clamp, pow for powr, sqrt for XeGTAO_FastSqrt.
std::string usual_name(std::string_view word);

/// A multiple of pi in the notation of formulas: "(pi/2)" for HALF_PI. Empty for other names.
std::optional<std::string> pi_in(std::string_view path);

}  // namespace shadefit::lint
