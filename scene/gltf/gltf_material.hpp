#pragma once

#include <cstddef>
#include <set>
#include <string>

#include "scene/files/json_place.hpp"
#include "scene/gltf/gltf_images.hpp"
#include "scene/materials/material.hpp"

/// A material of glTF 2.0 in the terms of one lobe and one Fresnel term.
namespace shadefit::scene {

/// What materials of one document are read with.
struct GltfReading {
  GltfImages& images;
  /// JSON pointers of what KHR_animation_pointer moves: "/materials/0/pbrMetallicRoughness/roughnessFactor".
  const std::set<std::string>& animated;
  const Conventions& conventions;
};

/// The material at `place`, the one with `index`. Metallic-roughness, or of
/// KHR_materials_pbrSpecularGlossiness, with KHR_materials_ior, KHR_materials_specular, KHR_materials_unlit.
/// Textures of roughness, metallic and gloss are read; those of colours are taken to hold anything from 0
/// to 1. So are colours of vertices, and factors that an animation moves. Other extensions are left out, with
/// a remark. Throws UserError naming file, place and rule. Source: Khronos Group 2021, "glTF 2.0
/// Specification", section 3.9 and appendix B, and the extensions named.
Material read_gltf_material(const JsonPlace& place, std::size_t index, bool has_vertex_colours,
                            const GltfReading& gltf);

/// The material of what names none: white, metallic and as rough as can be.
Material default_gltf_material(const std::string& file, bool has_vertex_colours,
                               const Conventions& conventions);

}  // namespace shadefit::scene
