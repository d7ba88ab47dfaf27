#pragma once

#include <string_view>

/// The known extensions of glTF.
namespace shadefit::scene {

/// Whether an extension is known.
bool is_known_extension(std::string_view name);

/// Whether an extension may add something to a picture that a plan does not cover.
/// Source: Khronos Group, "glTF Extension Registry", its ratified extensions and those of several vendors.
bool is_left_out(std::string_view name);

}  // namespace shadefit::scene
