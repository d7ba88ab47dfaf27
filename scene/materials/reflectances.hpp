#pragma once

#include <array>

#include "scene/materials/material.hpp"

/// Reflectances facing the surface, over all that textures may make of them.
namespace shadefit::scene {

using ColourRange = std::array<Range, 3>;

/// From nothing to a colour where a texture scales it, else that colour.
ColourRange scaled_colour(const std::array<double, 3>& colour, bool is_textured);

/// The metallic workflow over ranges: the reflectance of dielectrics where `metallic` is 0, the base colour
/// where it is 1, in a line between.
Range metallic_range(const Range& dielectric, const Range& base_colour, const Range& metallic);

/// The reflectance of a dielectric with KHR_materials_specular: min(F colour, 1) factor, F = ((ior - 1)/(ior
/// + 1))^2 in `facing`.
/// Source: Khronos Group 2021, "KHR_materials_specular" and "KHR_materials_ior".
Range dielectric_range(const Range& facing, const Range& specular_colour, const Range& specular);

}  // namespace shadefit::scene
