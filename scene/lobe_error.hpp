#pragma once

#include <span>

#include "scene/material.hpp"

/// How far a form of the lobe may move a picture.
///
/// What is shown of a light is min(g t, 1): t = c^n the lobe, g the rest of the specular term, which is
/// anything up to F (n + 2)/8 (a unit light of games, F the reflectance). With a form f in place of t it is
/// off by
///   |f - t| min(g, 1/max(f, t)),
/// at the worst g: either it is not clamped, or the larger of both is just not.
namespace shadefit::scene {

/// A lobe of a scene: the power, and the largest factor in front of it.
struct WeightedPower {
  double power;
  double factor;  ///< the largest F (n + 2)/8
};

/// The largest error of the plain Gaussian exp((n + x)(c - 1)) for a lobe, over all c in [0, 1]: proven not
/// to be exceeded, in exact arithmetic. It is found to 2 %, and what is below `enough` only as far as that it
/// is.
double gaussian_error(const WeightedPower& lobe, double offset, double enough);

/// The same, sampled and so from below: fast, to rule an offset out.
double sampled_gaussian_error(const WeightedPower& lobe, double offset);

/// The offset in [0, 3/2], to four digits, whose largest sampled error over all lobes with a power above 0 is
/// least.
double best_offset(std::span<const WeightedPower> lobes);

}  // namespace shadefit::scene
