#pragma once

#include <array>

#include "scene/materials/material.hpp"

/// Reflectances at normal incidence, over all possible texture values.
namespace shadefit::scene {

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
