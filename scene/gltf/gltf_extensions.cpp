#include "scene/gltf/gltf_extensions.hpp"

#include <fmt/format.h>

namespace shadefit::scene {
namespace {

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

}  // namespace

bool is_known_extension(std::string_view name) {
  return is_among(covered, name) || is_among(left_out, name);
}

bool is_left_out(std::string_view name) {
  return !is_among(covered, name);
}

}  // namespace shadefit::scene
