#pragma once

#include <set>
#include <vector>

#include "scene/materials/material.hpp"
#include "scene/plan/lobe_form.hpp"

/// Collects the lobes of a scene's materials.
namespace shadefit::scene {

/// The largest reflectance of a material in any channel, at any angle.
double largest_reflectance(const Material& material);

/// The largest F (n + 2)/8 of a material at that power.
double largest_factor(const Material& material, double power);

/// The lobes of several materials.
struct Lobes {
  std::vector<WeightedPower> all;   ///< each power once, with its largest factor, by rising power
  std::set<PowerTexture> textures;  ///< that powers are read from; only `none`: no power varies by pixel
  bool has_schlick = false;         ///< a reflectance rises with the angle
  bool is_coloured = false;         ///< a reflectance may differ between the channels

  bool is_textured() const { return textures.size() > textures.count(PowerTexture::none); }
  Range range() const;
  bool is_one_power() const { return range().is_constant() && !is_textured(); }
  double largest_factor() const;
};

/// For the marked materials: the power of each, or for a texture all powers from the least to the largest in
/// steps of 3 %. Filtering and mip levels can give any value between two texels.
Lobes lobes_of(const std::vector<Material>& materials, const std::vector<bool>& has_lobe);

}  // namespace shadefit::scene
