#include "scene/read_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "fit/support/user_error.hpp"
#include "scene/gltf/read_gltf.hpp"
#include "scene/gltf/read_mtl.hpp"
#include "scene/materials/uri.hpp"

namespace shadefit::scene {
namespace {

Scene read_one_file(const std::filesystem::path& file, const Conventions& conventions) {
  if (has_extension(file, ".gltf") || has_extension(file, ".glb")) return read_gltf(file, conventions);
  if (has_extension(file, ".mtl")) return read_mtl(file, conventions);
  if (has_extension(file, ".obj")) return read_obj(file, conventions);
  throw UserError(
      fmt::format("cannot read '{}': its name must end with .gltf, .glb, .mtl or .obj", file.string()));
}

/// The scenes below a folder by their paths, or the file itself.
std::vector<std::filesystem::path> files_at(const std::filesystem::path& path) {
  std::error_code error, ignored;
  if (!std::filesystem::is_directory(path, ignored)) return {path};
  std::vector<std::filesystem::path> files;
  const std::filesystem::recursive_directory_iterator end;
  for (std::filesystem::recursive_directory_iterator entry(path, error); !error && entry != end;
       entry.increment(error)) {
    const auto is_a = [&](const char* extension) { return has_extension(entry->path(), extension); };
    if (entry->is_regular_file(ignored) && (is_a(".gltf") || is_a(".glb") || is_a(".mtl")))
      files.push_back(entry->path());
  }
  if (error) throw UserError(fmt::format("cannot read '{}': {}", path.string(), error.message()));
  if (files.empty()) throw UserError(fmt::format("'{}' holds no .gltf, .glb or .mtl", path.string()));
  std::ranges::sort(files);
  return files;
}

}  // namespace

Scene read_scene(std::span<const std::filesystem::path> paths, const Conventions& conventions) {
  Scene scene;
  scene.conventions = conventions;
  std::vector<std::filesystem::path> files;
  for (const std::filesystem::path& path : paths)
    std::ranges::move(files_at(path), std::back_inserter(files));
  for (const std::filesystem::path& file : files) {
    Scene one = read_one_file(file, conventions);
    std::ranges::move(one.materials, std::back_inserter(scene.materials));
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
