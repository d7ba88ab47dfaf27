#include "scene/read_scene.hpp"

#include <fmt/format.h>

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

template <class T>
void append(std::vector<T>& all, std::vector<T> more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace

Scene read_scene(std::span<const std::filesystem::path> files, const Conventions& conventions) {
  Scene scene;
  scene.conventions = conventions;
  for (const std::filesystem::path& file : files) {
    Scene one = read_one_file(file, conventions);
    append(scene.materials, std::move(one.materials));
    append(scene.missing, std::move(one.missing));
    append(scene.unused, std::move(one.unused));
    append(scene.remarks, std::move(one.remarks));
    if (scene.materials.size() + scene.unused.size() > most_materials) {
      throw UserError(
          fmt::format("'{}': with it there are more than {} materials", file.string(), most_materials));
    }
    scene.lights += one.lights;
  }
  return scene;
}

}  // namespace shadefit::scene
