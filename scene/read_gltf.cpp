#include "scene/read_gltf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "fit/bounded_file.hpp"
#include "scene/extension.hpp"
#include "scene/glb.hpp"
#include "scene/gltf_images.hpp"
#include "scene/gltf_material.hpp"
#include "fit/json_document.hpp"
#include "scene/json_place.hpp"
#include "scene/limits.hpp"
#include "scene/place.hpp"

namespace shadefit::scene {
namespace {

/// Geometry and its motion, which take most of a document.
bool is_member_wanted(std::string_view key) {
  constexpr std::array<std::string_view, 12> unwanted{"accessors", "animations", "cameras",  "extras",
                                                      "matrix",    "rotation",   "samplers", "scale",
                                                      "scenes",    "skins",      "targets",  "translation"};
  return std::find(unwanted.begin(), unwanted.end(), key) == unwanted.end();
}

void require_version(const JsonPlace& root) {
  const JsonPlace version = required_member(required_member(root, "asset"), "version");
  if (!text_at(version).starts_with("2.")) refuse(version, "it must be 2.0");
}

/// Which materials primitives of meshes use; the default's number is that of all materials.
struct MaterialUses {
  std::set<std::size_t> with_vertex_colours;
  bool is_default_used = false;
};

MaterialUses uses_of_materials(const JsonPlace& root, std::size_t materials) {
  MaterialUses uses;
  const auto meshes = member(root, "meshes");
  for (std::size_t i = 0; meshes && i < element_count(*meshes); ++i) {
    const JsonPlace primitives = required_member(element(*meshes, i), "primitives");
    for (std::size_t j = 0; j < element_count(primitives); ++j) {
      const JsonPlace primitive = element(primitives, j);
      const auto index = member(primitive, "material");
      const std::size_t material = index ? whole_number(*index) : materials;
      if (index) indexed_element(*index, root, "materials");
      uses.is_default_used = uses.is_default_used || !index;
      const auto attributes = member(primitive, "attributes");
      if (attributes && member(*attributes, "COLOR_0")) uses.with_vertex_colours.insert(material);
    }
  }
  return uses;
}

std::optional<JsonPlace> lights_extension(const JsonPlace& object) {
  const auto extensions = member(object, "extensions");
  return extensions ? member(*extensions, "KHR_lights_punctual") : std::nullopt;
}

/// Nodes are read one after the other, whatever hierarchy they claim, so that no cycle matters.
int count_lights(const JsonPlace& root) {
  const nlohmann::json nothing = nlohmann::json::object();
  const JsonPlace holder =
      lights_extension(root).value_or(JsonPlace{&nothing, "/extensions/KHR_lights_punctual", root.file});
  int referenced = 0;
  const auto nodes = member(root, "nodes");
  for (std::size_t i = 0; nodes && i < element_count(*nodes); ++i) {
    const auto node = lights_extension(element(*nodes, i));
    if (!node) continue;
    indexed_element(required_member(*node, "light"), holder, "lights");
    ++referenced;
  }
  if (referenced > 0) return referenced;
  const auto lights = member(holder, "lights");
  return lights ? static_cast<int>(element_count(*lights)) : 0;
}

Scene read_document(const JsonPlace& root, const std::optional<Bytes>& binary,
                    const std::filesystem::path& file, const Conventions& conventions) {
  require_version(root);
  const auto array = member(root, "materials");
  const std::size_t count = array ? element_count(*array) : 0;
  if (count > most_materials)
    refuse(*array, fmt::format("there are {}, more than {}", count, most_materials));
  const MaterialUses uses = uses_of_materials(root, count);
  GltfImages images(root, binary, file);
  Scene scene;
  for (std::size_t i = 0; i < count; ++i) {
    const bool has_vertex_colours = uses.with_vertex_colours.contains(i);
    scene.materials.push_back(
        read_gltf_material(element(*array, i), i, has_vertex_colours, images, conventions));
  }
  if (uses.is_default_used || count == 0) {
    const bool has_vertex_colours = uses.with_vertex_colours.contains(count);
    scene.materials.push_back(default_gltf_material(file.string(), has_vertex_colours, conventions));
  }
  scene.lights = count_lights(root);
  scene.missing = images.missing_files();
  return scene;
}

}  // namespace

Scene read_gltf(const std::filesystem::path& file, const Conventions& conventions) {
  const bool is_binary = has_extension(file, ".glb");
  return read_gltf(read_bounded(file, is_binary ? most_glb_bytes : most_json_bytes), file, conventions);
}

Scene read_gltf(std::string_view content, const std::filesystem::path& file, const Conventions& conventions) {
  const std::string name = file.string(), quoted_name = fmt::format("'{}'", name);
  Glb parts{content, std::nullopt};
  if (has_extension(file, ".glb")) {
    parts = at_place(quoted_name, [&] { return parse_glb(bytes_of(content)); });
  }
  if (parts.json.size() > most_json_bytes) {
    throw UserError(fmt::format("{}: its JSON has {} bytes, more than the {} that it may have", quoted_name,
                                parts.json.size(), most_json_bytes));
  }
  const nlohmann::json document = parse_json(parts.json, name, is_member_wanted);
  return read_document({&document, "", name}, parts.binary, file, conventions);
}

}  // namespace shadefit::scene
