#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "scene/materials/material.hpp"

/// Scenes in glTF 2.0.
namespace shadefit::scene {

/// Size limits, checked before a file is read. Larger files are mostly geometry, which is not needed.
inline constexpr std::uintmax_t most_json_bytes = 64 << 20;
inline constexpr std::uintmax_t most_glb_bytes = 512 << 20;

/// Materials and lights of a .gltf or .glb file, by its name. Files that it names are searched in its folder
/// and below. If a mesh primitive names no material, or if there are no materials, the last material is the
/// specification's default, named "default". If there are primitives, materials that none of them uses in any
/// variant of KHR_materials_variants are unused. Throws UserError naming file, place and rule, also for an
/// unknown required extension.
Scene read_gltf(const std::filesystem::path& file, const Conventions& conventions);

/// The same for a file in memory. `file` names it; other files are searched in the folder of `file`.
Scene read_gltf(std::string_view content, const std::filesystem::path& file, const Conventions& conventions);

}  // namespace shadefit::scene
