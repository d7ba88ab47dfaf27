#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

/// The numbers of a Wavefront .mtl file that matter here, checked line by line: the loader takes for 0
/// whatever it cannot read, and has single precision.
namespace shadefit::scene {

/// What the lines of one material say.
struct MtlNumbers {
  std::string name = {};
  std::size_t line = 0;  ///< of its newmtl, from 1 on
  std::optional<double> shininess = {}, index_of_refraction = {}, roughness = {}, metallic = {};
  std::optional<std::array<double, 3>> diffuse = {}, specular = {};
  std::optional<int> illumination = {};
  std::set<std::string> left_out = {};  ///< keys of other lobes, Pc, Ps and aniso, that are not 0
};

/// The materials by their order. Each line of Ns, Ni, Pr, Pm, Pc, Ps, aniso, Kd, Ks and illum has to be a key
/// and numbers, of Kd and Ks three or one for all channels: finite and not negative, Pr and Pm at most 1. The
/// last line of a key counts. Throws UserError naming file, line, text and rule, also where there are more
/// than `most` materials, or where the file is no text. Source: Ramey, Rose, Tyerman 1995, "MTL material
/// format (Lightwave, OBJ)"; for Pr and Pm the extension to physically based shading of Exocortex
/// Technologies.
std::vector<MtlNumbers> checked_lines(std::string_view text, const std::string& file, std::size_t most);

}  // namespace shadefit::scene
