#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "scene/materials/texture.hpp"

/// The relevant lines of a Wavefront .mtl file.
namespace shadefit::scene {

/// A texture of a scalar.
struct ScalarMap {
  std::string name;  ///< as in the file; empty if the material has none
  Channel channel = Channel::red;
};

/// The values of one material.
struct MtlEntry {
  std::string name = {};
  std::size_t line = 0;  ///< the line number of its newmtl, from 1
  std::optional<double> shininess = {}, index_of_refraction = {}, roughness = {}, metallic = {};
  std::optional<std::array<double, 3>> diffuse = {}, specular = {}, emission = {};
  double opacity = 1;
  std::optional<int> illumination = {};
  ScalarMap shininess_map = {}, ambient_map = {}, roughness_map = {}, metallic_map = {};
  bool has_specular_map = false, has_diffuse_map = false, has_normal_map = false, has_emission_map = false,
       has_opacity_map = false;
  std::set<std::string> left_out = {};  ///< keys of other lobes (Pc, Ps and aniso) with a value that is not 0
};

/// The materials in the order of the file. Numbers must be finite and not negative, Pr and Pm at most 1; Kd,
/// Ks and Ke have three numbers or one for all channels. Maps have options, which begin with "-", then a file
/// name, which may have blanks; only the option -imfchan r|g|b is used, and any other channel counts as red.
/// The last line of a key counts. Throws UserError naming file, line, text and rule, also for more than
/// `most` materials and for a binary file. Source: Ramey, Rose, Tyerman 1995, "MTL material format
/// (Lightwave, OBJ)"; for Pr and Pm the extension to physically based shading of Exocortex Technologies.
std::vector<MtlEntry> parse_mtl(std::string_view text, const std::string& file, std::size_t most);

/// A line's first word, and the rest without the blanks around it.
struct Words {
  std::string_view key, values;
};
Words words_of_line(std::string_view line);

}  // namespace shadefit::scene
