#pragma once

#include <array>
#include <functional>
#include <string_view>

#include "scene/materials/material.hpp"

/// Converts the numbers and textures of files: roughness and gloss to specular powers, colours to
/// reflectances at normal incidence over all possible texture values.
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

using ColourRange = std::array<Range, 3>;

/// From 0 to a colour if a texture scales it, else exactly that colour.
ColourRange scaled_colour(const std::array<double, 3>& colour, bool is_textured);

/// The metallic workflow over ranges: linear from the reflectance of dielectrics at `metallic` = 0 to the
/// base colour at 1.
Range metallic_range(const Range& dielectric, const Range& base_colour, const Range& metallic);

/// The reflectance of a dielectric with KHR_materials_specular: min(F colour, 1) factor, F = ((ior - 1)/(ior
/// + 1))^2 in `facing`.
/// Source: Khronos Group 2021, "KHR_materials_specular" and "KHR_materials_ior".
Range dielectric_range(const Range& facing, const Range& specular_colour, const Range& specular);

}  // namespace shadefit::scene
