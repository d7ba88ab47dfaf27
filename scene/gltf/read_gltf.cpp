#include "scene/gltf/read_gltf.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <set>

#include "fit/input/bounded_file.hpp"
#include "fit/input/json_document.hpp"
#include "scene/gltf/glb.hpp"
#include "scene/gltf/gltf_images.hpp"
#include "scene/gltf/gltf_material.hpp"
#include "scene/materials/json_place.hpp"
#include "scene/materials/messages.hpp"
#include "scene/materials/uri.hpp"

namespace shadefit::scene {
namespace {

/// Source: Khronos Group, "glTF Extension Registry", its ratified extensions and those of several vendors.
/// The first six are read. The others are geometry, coding, visibility: they change no specular term.
/// Textures in their formats are not read; a material that uses one says so.
constexpr std::string_view covered =
    " KHR_lights_punctual KHR_materials_ior KHR_materials_pbrSpecularGlossiness KHR_materials_specular"
    " KHR_materials_unlit KHR_materials_variants EXT_mesh_gpu_instancing EXT_meshopt_compression"
    " EXT_texture_avif EXT_texture_webp KHR_draco_mesh_compression KHR_mesh_quantization"
    " KHR_meshopt_compression KHR_node_hoverability KHR_node_selectability KHR_node_visibility"
    " KHR_texture_basisu KHR_texture_transform KHR_xmp KHR_xmp_json_ld MSFT_texture_dds ";

/// They change a picture in a way that a plan does not cover.
constexpr std::string_view left_out =
    " EXT_lights_ies EXT_lights_image_based KHR_animation_pointer KHR_materials_anisotropy"
    " KHR_materials_clearcoat KHR_materials_diffuse_transmission KHR_materials_dispersion"
    " KHR_materials_emissive_strength KHR_materials_iridescence KHR_materials_sheen"
    " KHR_materials_transmission KHR_materials_volume MSFT_lod ";

bool is_among(std::string_view names, std::string_view name) {
  return name.find(' ') == name.npos && names.find(fmt::format(" {} ", name)) != names.npos;
}

/// Skips geometry and animation curves, which take most of a document. `rotation` and `scale` stay: textures
/// have them too.
bool is_member_wanted(std::string_view key) {
  constexpr std::array<std::string_view, 9> unwanted{
      "accessors", "cameras", "extras", "matrix", "samplers", "scenes", "skins", "targets", "translation"};
  return std::find(unwanted.begin(), unwanted.end(), key) == unwanted.end();
}

void require_version(const JsonPlace& root) {
  const JsonPlace version = required_member(required_member(root, "asset"), "version");
  if (!text_at(version).starts_with("2.")) refuse(version, "it must be 2.0");
}

/// Refuses a file that requires unknown extensions.
void require_known_extensions(const JsonPlace& root) {
  for_each_element(root, "extensionsRequired", [](const JsonPlace& name) {
    if (!is_among(covered, text_at(name)) && !is_among(left_out, text_at(name)))
      refuse(name, "the file requires this extension, and it is not known");
  });
}

/// The extensions that may add something to a picture that a plan does not cover, once each.
std::vector<std::string> extensions_left_out(const JsonPlace& root) {
  std::set<std::string> remarks;
  for_each_element(root, "extensionsUsed", [&](const JsonPlace& name) {
    if (!is_among(covered, text_at(name)))
      remarks.insert(fmt::format("{} is left out", shortened(text_at(name))));
  });
  return {remarks.begin(), remarks.end()};
}

/// The materials that mesh primitives use. The default material has the index `materials`.
struct MaterialUses {
  std::set<std::size_t> used, with_vertex_colours;

  /// A file without primitives is a library, so all its materials count as used.
  bool is_used(std::size_t material) const { return used.empty() || used.contains(material); }
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

/// Counts the lights of KHR_lights_punctual: those of nodes, or if nodes have none, all that are defined.
/// Adds a remark on those that are brighter than 1, the light that the tolerance assumes. Nodes are read as a
/// flat list, so cycles do no harm. Source: Khronos Group 2018, "KHR_lights_punctual".
void read_lights(const JsonPlace& root, Scene& scene) {
  const JsonPlace holder = member_or_empty(member_or_empty(root, "extensions"), "KHR_lights_punctual");
  std::set<std::string> used;
  for_each_element(root, "nodes", [&](const JsonPlace& place) {
    const auto node = extension(place, "KHR_lights_punctual");
    if (!node) return;
    used.insert(indexed_element(required_member(*node, "light"), holder, "lights").pointer);
    ++scene.lights;
  });
  int defined = 0, bright = 0;
  for_each_element(holder, "lights", [&](const JsonPlace& light) {
    ++defined;
    const double intensity = number_or(light, "intensity", 0, std::numeric_limits<double>::infinity(), 1);
    if (intensity > 1 && (used.empty() || used.contains(light.pointer))) ++bright;
  });
  if (used.empty()) scene.lights = defined;
  if (bright == 0) return;
  scene.remarks.push_back(fmt::format(
      "lights above 1: {} of {}. The tolerance is for a light of 1, which shows white: an error of "
      "these is as many times larger before exposure",
      bright, defined));
}

Scene read_document(const JsonPlace& root, const std::optional<std::string_view>& binary,
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
  const auto read = [&](const JsonPlace& place, std::size_t i) {
    return read_gltf_material(place, i, uses.with_vertex_colours.contains(i),
                              {images, animated, conventions});
  };
  Scene scene;
  for (std::size_t i = 0; i < count; ++i) {
    Material material = read(element(*array, i), i);
    if (uses.is_used(i)) {
      scene.materials.push_back(std::move(material));
    } else {
      scene.unused.push_back(std::move(material.name));
    }
  }
  if (uses.used.contains(count) || count == 0) {
    const nlohmann::json nothing = nlohmann::json::object();
    scene.materials.push_back(read({&nothing, "/materials/default", root.file}, count));
    scene.materials.back().name = "default";
  }
  scene.remarks = extensions_left_out(root);
  read_lights(root, scene);
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
    parts = at_place(quoted_name, [&] { return parse_glb(content); });
  }
  if (parts.json.size() > most_json_bytes) {
    throw UserError(fmt::format("{}: its JSON has {} bytes, more than the {} that it may have", quoted_name,
                                parts.json.size(), most_json_bytes));
  }
  const nlohmann::json document = parse_json(parts.json, name, is_member_wanted);
  return read_document({&document, "", name}, parts.binary, file, conventions);
}

}  // namespace shadefit::scene
