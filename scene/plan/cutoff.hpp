#pragma once

#include "scene/materials/material.hpp"

/// The cosines n.h at which a light can be skipped.
namespace shadefit::scene {

/// Safety factor, larger than the rounding of a computed cut-off.
inline constexpr double downwards = 1 - 0x1p-40;

/// A cosine n.h in [0, 1]. Below it a light adds at most `error` to a material's displayed value, in linear
/// values, for every power of the material.
double cutoff_of(double error, const Material& material);

}  // namespace shadefit::scene
