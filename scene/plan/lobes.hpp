#pragma once

#include <set>
#include <vector>

#include "scene/materials/material.hpp"
#include "scene/plan/lobe_form.hpp"

/// The lobes of a scene's materials, taken together.
namespace shadefit::scene {

/// The largest reflectance of a material in any channel, at any angle.
double largest_reflectance(const Material& material);

/// The largest F (n + 2)/8 of a material where it has that power.
double largest_factor(const Material& material, double power);

/// The least and the largest power of a material.
Range powers_of(const Material& material);

/// A power that is used, and by how much of what is shaded.
struct UsedPower {
  double power;
  double factor;  ///< the largest F (n + 2)/8
  double share;   ///< those of a scene's lobes sum to 1
};

/// What the lobes of several materials have in common.
struct Lobes {
  std::vector<WeightedPower> all;  ///< each power once, with its largest factor, by rising power
  /// Those of materials and of texels, each material as often as another; of a step the least stands for all.
  std::vector<UsedPower> used;
  std::set<PowerTexture> textures;  ///< that powers are read from; none but `none`: no power is the pixel's
  bool has_schlick = false;         ///< a reflectance rises with the angle
  bool is_coloured = false;         ///< a reflectance may differ between the channels
  bool has_metal = false;           ///< one facing the surface is above that of any dielectric

  bool is_textured() const { return textures.size() > textures.count(PowerTexture::none); }
  bool are_none() const { return all.empty(); }
  Range range() const;
  bool is_one_power() const { return range().is_constant() && !is_textured(); }
  double largest_factor() const;
};

/// Of the materials that are marked: the power of each, or of a texture all powers between the least and the
/// largest in steps of 3 %. Texels are filtered, and mip levels are made: between two of them anything may be
/// met.
Lobes lobes_of(const std::vector<Material>& materials, const std::vector<bool>& has_lobe);

}  // namespace shadefit::scene
