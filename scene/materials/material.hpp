#pragma once

#include <array>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

/// A material of a scene's file: a specular lobe with a power, and a Fresnel term between two reflectances.
/// The diffuse part is not used.
namespace shadefit::scene {

/// An interval of a quantity over a material's texels.
struct Range {
  double least = 0, most = 0;
  constexpr bool is_constant() const { return least == most; }
  bool operator==(const Range&) const = default;
};

/// The products of numbers that are not negative.
constexpr Range operator*(const Range& a, const Range& b) {
  return {a.least * b.least, a.most * b.most};
}

/// The dependence of the reflectance on the angle.
enum class FresnelTerm {
  none,     ///< a constant factor: Ks of Wavefront's format
  schlick,  ///< from F0 to F90
};

/// What a shader needs for a material, in words: "normal map", "clear coat" ..
using Features = std::set<std::string>;

/// The quantity of the texture that gives the power of each pixel.
enum class PowerTexture { none, roughness, gloss, power };

struct Material {
  std::string name;  ///< as in the file; "material 3" if it has none
  std::string file;
  bool is_unlit = false;  ///< it is not shaded

  FresnelTerm fresnel = FresnelTerm::schlick;
  std::array<Range, 3>
      f0;  ///< red, green, blue: linear reflectances at normal incidence; the factor for `none`
  Range f90{1, 1};
  /// A colour texture is not read; its values are within the ranges of `f0`. A pixel's channels may differ
  /// even if the ranges are equal.
  bool has_unread_colours = false;

  Range power;                                      ///< of cos^power(n.h); 0 is a constant, not a lobe
  PowerTexture power_texture = PowerTexture::none;  ///< `none` if all texels agree
  bool is_power_textured() const { return power_texture != PowerTexture::none; }

  /// Unknown data, taken at its full range: "roughness texture 'a.png' is missing", one line each.
  std::vector<std::string> unknowns;
  /// Values that were changed to be usable: "Ns = 1e+30 is taken for 1e+09", one line each.
  std::vector<std::string> remarks;

  Features features;  ///< empty without `Conventions::has_features`

  bool operator==(const Material&) const = default;
};

/// How files are read: the conversion of stored numbers to powers, and whether for features.
struct Conventions {
  /// alpha = roughness^2 (Burley 2012, "Physically-based shading at Disney"), or roughness itself.
  bool is_roughness_squared = true;
  /// A gloss g is 1 - roughness (KHR_materials_pbrSpecularGlossiness), or a power 2^(10 g + 1) (Lagarde 2011,
  /// "Adopting a physically based shading model").
  bool is_gloss_exponential = false;
  /// map_Ka is metallic and map_Ns is roughness (the seed document's exporter); otherwise the maps have their
  /// standard meaning.
  bool are_maps_pbr = false;
  /// A smaller roughness is raised to this one, as engines do: Filament to 0.045, three.js to 0.0525. 0: no
  /// limit.
  double min_roughness = 0;
  bool has_features = false;  ///< whether the features of materials are read
};

/// The least roughness that an engine keeps: MIN_PERCEPTUAL_ROUGHNESS of Filament,
/// shaders/src/common_material.fs at 0371a805. three.js has 0.0525.
inline constexpr double least_engine_roughness = 0.045;

/// At this power a lobe is narrower than any light. Larger powers are reduced to it, with a remark.
inline constexpr double most_power = 1e9;

/// The largest accepted Ks, although a colour should be at most 1. With the largest power, the normalised
/// lobe still fits in a float.
inline constexpr double most_factor = 1e6;

/// The most materials of all files of a scene together. A material takes some thousand bytes in memory but
/// may take only nine in a file: without a limit, a file of 64 MiB could use all memory.
inline constexpr std::size_t most_materials = 65536;

/// The contents of all files.
struct Scene {
  std::vector<Material> materials;
  Conventions conventions = {};  ///< for the conversion of its numbers to powers
  int lights = 0;                ///< punctual lights; 0 if the files name none
  /// The names of unused materials. They are not in `materials`.
  std::vector<std::string> unused = {};
  /// What a plan does not cover, of lights and of the files as a whole, one line each.
  std::vector<std::string> remarks = {};
};

}  // namespace shadefit::scene
