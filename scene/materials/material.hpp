#pragma once

#include <array>
#include <string>
#include <vector>

/// What a scene's file says of a material, in the terms of one shading: a specular lobe with a power, a
/// Fresnel term between two reflectances, a diffuse part that nothing here is about.
namespace shadefit::scene {

/// An interval of a quantity over a material's texels.
struct Range {
  double least = 0, most = 0;
  bool is_constant() const { return least == most; }
  bool operator==(const Range&) const = default;
};

/// How often a specular power is used: the share of a material's texels.
struct PowerShare {
  double power;  ///< of cos^power(n.h); 0 is a constant and no lobe
  double share;  ///< they sum to 1
  bool operator==(const PowerShare&) const = default;
};

/// How the reflectance runs with the angle.
enum class FresnelTerm {
  none,     ///< a factor alone: Ks of Wavefront's format
  schlick,  ///< from F0 to F90
};

/// What a texture stores that the power is read from, pixel by pixel.
enum class PowerTexture { none, roughness, gloss, power };

struct Material {
  std::string name;  ///< as the file has it; "material 3" where it has none
  std::string file;
  bool is_unlit = false;  ///< nothing of it is shaded

  FresnelTerm fresnel = FresnelTerm::schlick;
  std::array<Range, 3>
      f0;  ///< red, green, blue: linear reflectances facing the surface; of `none`, the factor
  Range f90{1, 1};
  /// A texture of colours, which is not read, is within the ranges of `f0`: a pixel's channels may differ
  /// even where the ranges do not.
  bool has_unread_colours = false;

  /// By rising power, at least one. A power that is the same everywhere is one share.
  std::vector<PowerShare> powers;
  PowerTexture power_texture = PowerTexture::none;  ///< none where all texels agree
  bool is_power_textured() const { return power_texture != PowerTexture::none; }

  /// What the files do not say, taken at its full range: "roughness texture 'a.png' is missing", a line each.
  std::vector<std::string> unknowns;
  /// What was changed to be usable: "Ns = 1e+30 is taken for 1e+09", a line each.
  std::vector<std::string> remarks;

  bool operator==(const Material&) const = default;
};

/// How stored numbers become powers.
struct Conventions {
  /// alpha = roughness^2 (Burley 2012, "Physically-based shading at Disney"), or roughness itself.
  bool is_roughness_squared = true;
  /// A gloss g is 1 - roughness (KHR_materials_pbrSpecularGlossiness), or a power 2^(10 g + 1) (Lagarde 2011,
  /// "Adopting a physically based shading model").
  bool is_gloss_exponential = false;
  /// map_Ka is metallic and map_Ns roughness (the seed document's exporter), or what the names say.
  bool are_maps_pbr = false;
  /// A smaller roughness is taken for this one, as engines do: Filament below 0.045, three.js below 0.0525.
  /// 0: none is.
  double min_roughness = 0;
};

/// The least roughness that an engine keeps: MIN_PERCEPTUAL_ROUGHNESS of Filament,
/// shaders/src/common_material.fs at 0371a805 (0.089 on mobile processors). three.js has 0.0525,
/// src/renderers/shaders/ShaderChunk/ lights_physical_fragment.glsl.js at 03bf3954, and the specification of
/// glTF none.
inline constexpr double least_engine_roughness = 0.045;

/// Beyond this a lobe is narrower than any light: larger powers are taken for it, and that is said.
inline constexpr double most_power = 1e9;

/// The largest Ks, which is a colour and should be at most 1: with the largest power a float still holds its
/// normalised lobe.
inline constexpr double most_factor = 1e6;

/// What the files hold together.
struct Scene {
  std::vector<Material> materials;
  Conventions conventions = {};  ///< by which its numbers became powers
  int lights = 0;                ///< punctual ones; 0 where the files name none
  /// Files that were named and are missing, without a loss: geometry, buffers.
  std::vector<std::string> missing = {};
  /// The names of materials that nothing is drawn with. They are not among `materials`.
  std::vector<std::string> unused = {};
  /// What no plan counts, of lights and of the files as a whole, a line each.
  std::vector<std::string> remarks = {};
};

}  // namespace shadefit::scene
