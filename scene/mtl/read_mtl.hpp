#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "scene/materials/material.hpp"

/// Scenes in Wavefront's formats.
namespace shadefit::scene {

/// Before a file is read, its size is compared with this.
inline constexpr std::uintmax_t most_mtl_bytes = 64 << 20;

/// An .obj is read line by line and not kept; this bounds the time.
inline constexpr std::uintmax_t most_obj_bytes = std::uintmax_t{4} << 30;

/// The materials of an .mtl file. With Pr, Pm, their maps, or by Conventions::are_maps_pbr, a material is
/// metallic-roughness with Kd for its base colour and F0 of dielectrics from Ni, 0.04 without. Any other has
/// the power Ns and the factor Ks without a Fresnel term; none at all by illum 0 and 1. map_Ns scales Ns and
/// is read, map_Ks scales Ks and is taken to hold anything from 0 to 1. Maps are looked for in the file's
/// folder and below; of those that are missing, or neither PNG nor JPEG, nothing is known. Throws UserError
/// naming file, line or material, and rule.
Scene read_mtl(const std::filesystem::path& file, const Conventions& conventions);

/// The same of a file that is in memory already; `file` names it, and its folder is where maps are looked
/// for.
Scene read_mtl(std::string_view text, const std::filesystem::path& file, const Conventions& conventions);

/// The materials of the libraries that the lines mtllib of an .obj file name, each library once. Those that
/// no line usemtl names are unused, as long as there is one. Nothing else of the file is read. Throws
/// UserError for a library that is missing or outside of the file's folder.
Scene read_obj(const std::filesystem::path& file, const Conventions& conventions);

}  // namespace shadefit::scene
