#pragma once

#include <filesystem>
#include <span>

#include "scene/materials/material.hpp"

/// Reads scenes from any number of files.
namespace shadefit::scene {

/// The contents of all files, in their order. The extension decides the format: .gltf, .glb, .mtl or .obj. A
/// folder stands for all .gltf, .glb and .mtl in it and below. Throws UserError for any other extension, for
/// a folder without a scene, and like the reader of each format.
Scene read_scene(std::span<const std::filesystem::path> paths, const Conventions& conventions);

}  // namespace shadefit::scene
