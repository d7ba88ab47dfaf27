#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "scene/materials/material.hpp"

/// Scenes in glTF 2.0.
namespace shadefit::scene {

/// Before a file is read, its size is compared with these; larger ones are mostly geometry, which is not
/// wanted.
inline constexpr std::uintmax_t most_json_bytes = 64 << 20;
inline constexpr std::uintmax_t most_glb_bytes = 512 << 20;

/// Materials and lights of a .gltf or .glb file, by its name. Files that it names are looked for in its
/// folder and below; what is missing is said in the scene. Where a primitive of a mesh names no material, and
/// where there are none at all, the last is the specification's default, named "default". Materials that
/// no primitive has, in no variant of KHR_materials_variants, are unused, as long as there are primitives. A
/// factor that KHR_animation_pointer moves takes its whole range. Throws UserError naming file, place and
/// rule, also for an extension that the file requires and that is not known.
Scene read_gltf(const std::filesystem::path& file, const Conventions& conventions);

/// The same of a file that is in memory already; `file` names it, and its folder is where others are looked
/// for.
Scene read_gltf(std::string_view content, const std::filesystem::path& file, const Conventions& conventions);

}  // namespace shadefit::scene
