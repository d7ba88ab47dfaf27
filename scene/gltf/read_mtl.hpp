#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "scene/materials/material.hpp"

/// Scenes in Wavefront's formats.
namespace shadefit::scene {

/// A size limit, checked before a file is read.
inline constexpr std::uintmax_t most_mtl_bytes = 64 << 20;

/// An .obj is read line by line and not kept; this bounds the time.
inline constexpr std::uintmax_t most_obj_bytes = std::uintmax_t{4} << 30;

/// The materials of an .mtl file. With Pr, Pm, their maps, or by Conventions::are_maps_pbr, a material is
/// metallic-roughness: Kd is its base colour, and F0 of dielectrics comes from Ni (0.04 without Ni). Any
/// other material has the power Ns and the factor Ks without a Fresnel term, and no lobe with illum 0 and 1.
/// map_Ns scales Ns and is read; map_Ks scales Ks and counts as anything from 0 to 1. Maps are searched in
/// the file's folder and below; a map that is missing, or neither PNG nor JPEG, is unknown. Throws UserError
/// naming file, line or material, and rule.
Scene read_mtl(const std::filesystem::path& file, const Conventions& conventions);

/// The same for a file in memory. `file` names it; maps are searched in the folder of `file`.
Scene read_mtl(std::string_view text, const std::filesystem::path& file, const Conventions& conventions);

/// The materials of the libraries in the mtllib lines of an .obj file, each library once. If there are usemtl
/// lines, materials that none of them names are unused. Nothing else of the file is read. Throws UserError
/// for a library that is missing or outside the file's folder.
Scene read_obj(const std::filesystem::path& file, const Conventions& conventions);

}  // namespace shadefit::scene
