#pragma once

#include "scene/materials/material.hpp"

/// Which cosines n.h a light need not be asked at.
namespace shadefit::scene {

/// More than what is computed of a cut-off rounds.
inline constexpr double downwards = 1 - 0x1p-40;

/// A cosine n.h in [0, 1] below which a light adds no more than `error` to what a material shows, in linear
/// values, whichever of its powers a pixel has.
double cutoff_of(double error, const Material& material);

}  // namespace shadefit::scene
