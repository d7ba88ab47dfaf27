#include "scene/read_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "fit/support/user_error.hpp"
#include "scene/files/uri.hpp"
#include "scene/gltf/read_gltf.hpp"
#include "scene/mtl/read_mtl.hpp"

namespace shadefit::scene {
namespace {

Scene read_one_file(const std::filesystem::path& file, const Conventions& conventions) {
  if (has_extension(file, ".gltf") || has_extension(file, ".glb")) return read_gltf(file, conventions);
  if (has_extension(file, ".mtl")) return read_mtl(file, conventions);
  if (has_extension(file, ".obj")) return read_obj(file, conventions);
  throw UserError(
      fmt::format("cannot read '{}': its name must end with .gltf, .glb, .mtl or .obj", file.string()));
}

}  // namespace

Scene read_scene(std::span<const std::filesystem::path> files, const Conventions& conventions) {
  Scene scene;
  scene.conventions = conventions;
  for (const std::filesystem::path& file : files) {
    Scene one = read_one_file(file, conventions);
    std::ranges::move(one.materials, std::back_inserter(scene.materials));
    std::ranges::move(one.missing, std::back_inserter(scene.missing));
    std::ranges::move(one.unused, std::back_inserter(scene.unused));
    std::ranges::move(one.remarks, std::back_inserter(scene.remarks));
    if (scene.materials.size() + scene.unused.size() > most_materials) {
      throw UserError(
          fmt::format("'{}': with it there are more than {} materials", file.string(), most_materials));
    }
    scene.lights += one.lights;
  }
  return scene;
}

}  // namespace shadefit::scene
