#pragma once

#include <cstddef>
#include <set>
#include <string>

#include "scene/gltf/gltf_images.hpp"
#include "scene/materials/json_place.hpp"
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
/// KHR_materials_unlit. Textures of roughness, metallic and gloss are read. Colour textures and vertex
/// colours count as anything from 0 to 1. Throws UserError naming file, place and rule. Source: Khronos Group
/// 2021, "glTF 2.0 Specification", section 3.9 and appendix B, and the extensions named.
Material read_gltf_material(const JsonPlace& place, std::size_t index, bool has_vertex_colours,
                            const GltfReading& gltf);

/// What a shader needs for the material at `place`, by value: a factor that is 0 needs nothing, nor does the
/// texture that it multiplies. Textures of metallic and roughness are needed if their texels differ; other
/// textures are not read and count as needed. So do vertex colours, and a factor that is animated. Nothing
/// passes through a metal: where all is metal, transmission, volume, index of refraction and specular are not
/// needed. Throws UserError naming file, place and rule. Source: as for `read_gltf_material`.
Features read_gltf_features(const JsonPlace& place, bool has_vertex_colours, const GltfReading& gltf);

}  // namespace shadefit::scene
