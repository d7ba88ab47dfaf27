#pragma once

#include <filesystem>
#include <span>

#include "scene/materials/material.hpp"

/// Reads scenes from any number of files.
namespace shadefit::scene {

/// The contents of all files, in their order. The extension decides the format: .gltf, .glb, .mtl or .obj.
/// Throws UserError for any other extension, and like the reader of each format.
Scene read_scene(std::span<const std::filesystem::path> files, const Conventions& conventions);

}  // namespace shadefit::scene
