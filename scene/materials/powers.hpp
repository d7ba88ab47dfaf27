#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "scene/materials/material.hpp"
#include "scene/materials/texture.hpp"

/// Converts the roughness or gloss of files, a number or a texture, to specular powers.
namespace shadefit::scene {

/// The power of a roughness in [0, 1], raised to the minimum of the conventions if it is smaller. Infinite at
/// 0; 0 at 1, where the lobe is a constant.
double power_of_roughness(double stored, const Conventions& conventions);

/// The power of a gloss in [0, 1].
double power_of_gloss(double gloss, const Conventions& conventions);

/// Converts a stored number to a power, which is never negative and may be infinite.
using PowerOf = std::function<double(double)>;

/// The powers of a texture: of code/255 times `factor`, with the share of texels with that code.
std::vector<PowerShare> power_shares(const Histogram& texels, double factor, const PowerOf& power);

/// Gives a material the powers of a texture. If all texels agree, the power becomes a constant of the
/// material, because filtering cannot change it.
void take_powers(Material& material, std::vector<PowerShare> powers, PowerTexture texture);

/// An unknown texture: all codes are equally frequent.
Histogram unknown_texture();

/// The values of a texture times `factor`, from the least to the most.
Range range_of_texture(const Histogram& texels, double factor);

/// Reduces larger powers to `most_power`, and remarks on the largest: "`what` = 1e+30 is taken for 1e+09".
void limit_powers(Material& material, std::string_view what);

}  // namespace shadefit::scene
