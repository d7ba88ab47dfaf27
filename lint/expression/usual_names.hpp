#pragma once

#include <optional>
#include <string>
#include <string_view>

/// What names of programs mean, whatever the language.
namespace shadefit::lint {

/// Whether the word is a type whose constructor keeps the one number that it is given: vec3, f32, Vec3.
bool is_number_type(std::string_view word);

/// The usual name of a function: of Clamp, powr and XeGTAO_FastSqrt the names clamp, pow and sqrt.
std::string usual_name(std::string_view word);

/// A multiple of pi as formulas write it: of HALF_PI the text "(pi/2)". Empty for other names.
std::optional<std::string> pi_in(std::string_view path);

}  // namespace shadefit::lint
