#include "scene/gltf/read_gltf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "fit/support/bounded_file.hpp"
#include "fit/support/json_document.hpp"
#include "scene/files/json_place.hpp"
#include "scene/files/limits.hpp"
#include "scene/files/place.hpp"
#include "scene/files/short_text.hpp"
#include "scene/gltf/extension.hpp"
#include "scene/gltf/glb.hpp"
#include "scene/gltf/gltf_extensions.hpp"
#include "scene/gltf/gltf_images.hpp"
#include "scene/gltf/gltf_lights.hpp"
#include "scene/gltf/gltf_material.hpp"

namespace shadefit::scene {
namespace {

/// Skips geometry and animation curves, which take most of a document.
bool is_member_wanted(std::string_view key) {
  constexpr std::array<std::string_view, 11> unwanted{"accessors", "cameras",  "extras",     "matrix",
                                                      "rotation",  "samplers", "scale",      "scenes",
                                                      "skins",     "targets",  "translation"};
  return std::find(unwanted.begin(), unwanted.end(), key) == unwanted.end();
}

void require_version(const JsonPlace& root) {
  const JsonPlace version = required_member(required_member(root, "asset"), "version");
  if (!text_at(version).starts_with("2.")) refuse(version, "it must be 2.0");
}

/// Calls `use` with each element of the array `key` of an object, if it exists.
template <class Use>
void for_each_element(const JsonPlace& object, std::string_view key, const Use& use) {
  const auto array = member(object, key);
  for (std::size_t i = 0; array && i < element_count(*array); ++i) use(element(*array, i));
}

/// Refuses a file that requires unknown extensions.
void require_known_extensions(const JsonPlace& root) {
  for_each_element(root, "extensionsRequired", [](const JsonPlace& name) {
    if (use_of_extension(text_at(name)) == ExtensionUse::unknown)
      refuse(name, "the file requires this extension, and it is not known");
  });
}

/// The ignored extensions outside materials; each material remarks on its own extensions.
std::vector<std::string> extensions_left_out(const JsonPlace& root) {
  std::set<std::string> of_materials, remarks;
  for_each_element(root, "materials", [&](const JsonPlace& material) {
    const auto extensions = member(material, "extensions");
    if (!extensions) return;
    for (const auto& [name, ignored] : extensions->value->items()) of_materials.insert(name);
  });
  for_each_element(root, "extensionsUsed", [&](const JsonPlace& place) {
    const std::string_view name = text_at(place);
    const ExtensionUse use = use_of_extension(name);
    const bool is_left_out = use == ExtensionUse::left_out || use == ExtensionUse::unknown;
    if (is_left_out && !of_materials.contains(std::string(name)))
      remarks.insert(fmt::format("{} is left out", shortened(name)));
  });
  return {remarks.begin(), remarks.end()};
}

/// The materials that mesh primitives use. The default material has the index `materials`.
struct MaterialUses {
  std::set<std::size_t> used, with_vertex_colours;
  /// A file without primitives is a library, so all its materials count as used; levels of detail name
  /// further ones.
  bool are_all_used = false;

  bool is_used(std::size_t material) const { return are_all_used || used.contains(material); }
};

/// Includes the materials of variants, which are chosen at run time.
MaterialUses uses_of_materials(const JsonPlace& root, std::size_t materials) {
  MaterialUses uses;
  const auto add = [&](const JsonPlace& primitive, const std::optional<JsonPlace>& index) {
    const std::size_t material = index ? whole_number(*index) : materials;
    if (index) indexed_element(*index, root, "materials");
    uses.used.insert(material);
    const auto attributes = member(primitive, "attributes");
    if (attributes && member(*attributes, "COLOR_0")) uses.with_vertex_colours.insert(material);
  };
  for_each_element(root, "meshes", [&](const JsonPlace& mesh) {
    required_member(mesh, "primitives");
    for_each_element(mesh, "primitives", [&](const JsonPlace& primitive) {
      add(primitive, member(primitive, "material"));
      if (const auto variants = extension(primitive, "KHR_materials_variants")) {
        for_each_element(*variants, "mappings", [&](const JsonPlace& mapping) {
          add(primitive, required_member(mapping, "material"));
        });
      }
    });
  });
  uses.are_all_used = uses.used.empty();
  for_each_element(root, "extensionsUsed", [&](const JsonPlace& name) {
    uses.are_all_used = uses.are_all_used || text_at(name) == "MSFT_lod";
  });
  return uses;
}

/// The animated JSON pointers, except those of nodes.
std::set<std::string> animated_pointers(const JsonPlace& root) {
  constexpr std::size_t longest = 256;  // pointers of factors are shorter
  std::set<std::string> pointers;
  for_each_element(root, "animations", [&](const JsonPlace& animation) {
    for_each_element(animation, "channels", [&](const JsonPlace& channel) {
      const auto object = extension(required_member(channel, "target"), "KHR_animation_pointer");
      if (!object) return;
      const std::string_view pointer = text_at(required_member(*object, "pointer"));
      if (pointer.size() <= longest) pointers.emplace(pointer);
    });
  });
  return pointers;
}

Scene read_document(const JsonPlace& root, const std::optional<Bytes>& binary,
                    const std::filesystem::path& file, const Conventions& conventions) {
  require_version(root);
  require_known_extensions(root);
  const auto array = member(root, "materials");
  const std::size_t count = array ? element_count(*array) : 0;
  if (count > most_materials)
    refuse(*array, fmt::format("there are {}, more than {}", count, most_materials));
  const MaterialUses uses = uses_of_materials(root, count);
  const std::set<std::string> animated = animated_pointers(root);
  GltfImages images(root, binary, file);
  Scene scene;
  for (std::size_t i = 0; i < count; ++i) {
    const bool has_vertex_colours = uses.with_vertex_colours.contains(i);
    Material material =
        read_gltf_material(element(*array, i), i, has_vertex_colours, {images, animated, conventions});
    if (uses.is_used(i)) {
      scene.materials.push_back(std::move(material));
    } else {
      scene.unused.push_back(std::move(material.name));
    }
  }
  if (uses.used.contains(count) || count == 0) {
    const bool has_vertex_colours = uses.with_vertex_colours.contains(count);
    scene.materials.push_back(default_gltf_material(file.string(), has_vertex_colours, conventions));
  }
  const GltfLights lights = read_gltf_lights(root, animated);
  scene.lights = lights.count;
  scene.missing = images.missing_files();
  scene.remarks = extensions_left_out(root);
  if (!lights.remark.empty()) scene.remarks.push_back(lights.remark);
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
