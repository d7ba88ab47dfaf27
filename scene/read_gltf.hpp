#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "scene/material.hpp"

/// Scenes in glTF 2.0.
namespace shadefit::scene {

/// Before a file is read, its size is compared with these; larger ones are mostly geometry, which is not
/// wanted.
inline constexpr std::uintmax_t most_json_bytes = 64 << 20;
inline constexpr std::uintmax_t most_glb_bytes = 512 << 20;

/// Materials and lights of a .gltf or .glb file, by its name. Files that it names are looked for in its
/// folder and below; what is missing is said in the scene. Where a primitive of a mesh names no material, and
/// where there are none at all, the last is the specification's default, named "default". Lights are those
/// that nodes have, or where nodes have none, those defined. Throws UserError naming file, place and rule.
Scene read_gltf(const std::filesystem::path& file, const Conventions& conventions);

/// The same of a file that is in memory already; `file` names it, and its folder is where others are looked
/// for.
Scene read_gltf(std::string_view content, const std::filesystem::path& file, const Conventions& conventions);

}  // namespace shadefit::scene
