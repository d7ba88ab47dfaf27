#pragma once

#include <string_view>

/// The known extensions of glTF.
namespace shadefit::scene {

enum class ExtensionUse {
  counted,   ///< the plan depends on it, and it is read
  harmless,  ///< geometry, coding, visibility: it changes no specular term
  left_out,  ///< it adds something to a picture that a plan does not cover
  unknown,
};

/// Source: Khronos Group, "glTF Extension Registry", its ratified extensions and those of several vendors.
ExtensionUse use_of_extension(std::string_view name);

}  // namespace shadefit::scene
