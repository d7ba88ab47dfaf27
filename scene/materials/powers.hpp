#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "scene/materials/material.hpp"
#include "scene/textures/texture.hpp"

/// From what files store, roughness or gloss, one number or a texture of it, to specular powers.
namespace shadefit::scene {

/// The power of a roughness in [0, 1], taken for the conventions' least where it is smaller: infinite at 0,
/// and 0 at 1, where the lobe is a constant.
double power_of_roughness(double stored, const Conventions& conventions);

/// The power of a gloss in [0, 1].
double power_of_gloss(double gloss, const Conventions& conventions);

/// A stored number made a power; never falls below 0, and may be infinite.
using PowerOf = std::function<double(double)>;

/// The powers of a texture: of code/255 times `factor`, by the share of texels with that code.
std::vector<PowerShare> power_shares(const Histogram& texels, double factor, const PowerOf& power);

/// Gives a material the powers of a texture. Where all texels agree it is one of the material's own: no
/// filter makes another of them.
void take_powers(Material& material, std::vector<PowerShare> powers, PowerTexture texture);

/// A texture of which nothing is known: each code as often as another.
Histogram unknown_texture();

/// The values of a texture times `factor`, from the least to the most.
Range range_of_texture(const Histogram& texels, double factor);

/// Takes `most_power` for powers beyond it, and remarks on the largest: "`what` = 1e+30 is taken for 1e+09".
void limit_powers(Material& material, std::string_view what);

}  // namespace shadefit::scene
