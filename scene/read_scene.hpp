#pragma once

#include <filesystem>
#include <span>

#include "scene/materials/material.hpp"

/// Scenes of any number of files.
namespace shadefit::scene {

/// What the files hold together, in their order. By their extension they are .gltf, .glb, .mtl or .obj.
/// Throws UserError for another one, and as the reader of each format says.
Scene read_scene(std::span<const std::filesystem::path> files, const Conventions& conventions);

}  // namespace shadefit::scene
