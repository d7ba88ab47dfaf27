#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "scene/textures/texture.hpp"

/// The lines of a Wavefront .mtl file that matter here.
namespace shadefit::scene {

/// A texture of a scalar.
struct ScalarMap {
  std::string name;  ///< as the file has it; empty where the material has none
  Channel channel = Channel::red;
};

/// What the lines of one material say.
struct MtlEntry {
  std::string name = {};
  std::size_t line = 0;  ///< of its newmtl, from 1 on
  std::optional<double> shininess = {}, index_of_refraction = {}, roughness = {}, metallic = {};
  std::optional<std::array<double, 3>> diffuse = {}, specular = {};
  std::optional<int> illumination = {};
  ScalarMap shininess_map = {}, ambient_map = {}, roughness_map = {}, metallic_map = {};
  bool has_specular_map = false, has_diffuse_map = false;
  std::set<std::string> left_out = {};  ///< keys of other lobes, Pc, Ps and aniso, that are not 0
};

/// The materials by their order. Each line of Ns, Ni, Pr, Pm, Pc, Ps, aniso, Kd, Ks and illum has to be a key
/// and numbers, of Kd and Ks three or one for all channels: finite and not negative, Pr and Pm at most 1. A
/// line of map_Ns, map_Ka, map_Pr, map_Pm, map_Ks or map_Kd has options, which begin with "-", then the name
/// of a file, which may have blanks. Of the options only -imfchan r|g|b counts here; any other channel is
/// taken for red. The last line of a key counts. Throws UserError naming file, line, text and rule, also
/// where there are more than `most` materials, or where the file is no text. Source: Ramey, Rose, Tyerman
/// 1995, "MTL material format (Lightwave, OBJ)"; for Pr and Pm the extension to physically based shading of
/// Exocortex Technologies.
std::vector<MtlEntry> parse_mtl(std::string_view text, const std::string& file, std::size_t most);

}  // namespace shadefit::scene
