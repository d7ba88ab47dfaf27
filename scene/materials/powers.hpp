#pragma once

#include <functional>
#include <string_view>

#include "scene/materials/material.hpp"

/// Converts the roughness or gloss of files, a number or a texture, to specular powers.
namespace shadefit::scene {

/// The power of a roughness in [0, 1], raised to the minimum of the conventions if it is smaller. Infinite at
/// 0; 0 at 1, where the lobe is a constant.
double power_of_roughness(double stored, const Conventions& conventions);

/// The power of a gloss in [0, 1].
double power_of_gloss(double gloss, const Conventions& conventions);

/// Gives a material the powers of a range of stored numbers. `power` is monotone, never negative, and may be
/// infinite. Powers above `most_power` are reduced to it, with a remark on the largest: "`what` = 1e+30 is
/// taken for 1e+09". `texture` holds the numbers, if they differ.
void take_powers(Material& material, const Range& stored, const std::function<double(double)>& power,
                 PowerTexture texture, std::string_view what = "the specular power");

}  // namespace shadefit::scene
