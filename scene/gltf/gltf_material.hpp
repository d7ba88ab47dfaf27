#pragma once

#include <cstddef>
#include <set>
#include <string>

#include "scene/files/json_place.hpp"
#include "scene/gltf/gltf_images.hpp"
#include "scene/materials/material.hpp"

/// Converts a glTF 2.0 material to one lobe and one Fresnel term.
namespace shadefit::scene {

/// The shared inputs for reading the materials of one document.
struct GltfReading {
  GltfImages& images;
  /// JSON pointers that KHR_animation_pointer animates: "/materials/0/pbrMetallicRoughness/roughnessFactor".
  const std::set<std::string>& animated;
  const Conventions& conventions;
};

/// The material at `place`, the one with `index`. It may use metallic-roughness or
/// KHR_materials_pbrSpecularGlossiness, and KHR_materials_ior, KHR_materials_specular and
/// KHR_materials_unlit. Textures of roughness, metallic and gloss are read. Colour textures, vertex colours
/// and animated factors count as anything from 0 to 1. Other extensions are ignored with a remark. Throws
/// UserError naming file, place and rule. Source: Khronos Group 2021, "glTF 2.0 Specification", section 3.9
/// and appendix B, and the extensions named.
Material read_gltf_material(const JsonPlace& place, std::size_t index, bool has_vertex_colours,
                            const GltfReading& gltf);

/// The default material of primitives without one: white, metallic and fully rough.
Material default_gltf_material(const std::string& file, bool has_vertex_colours,
                               const Conventions& conventions);

}  // namespace shadefit::scene
