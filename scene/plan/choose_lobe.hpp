#pragma once

#include <string>

#include "fit/support/checkpoint.hpp"
#include "scene/plan/lobes.hpp"
#include "scene/plan/rounding_error.hpp"
#include "scene/plan/shown_scale.hpp"

/// Chooses the cheapest form of the lobe that is accurate enough.
namespace shadefit::scene {

/// The allowed error of a form, and how it is measured.
struct LobeBudget {
  double allowed;  ///< on the scale, for one light, including rounding
  ShownScale scale;
  PixelPrecision precision;
  bool has_fresnel;           ///< for the rounding of other terms than the lobe
  bool is_gloss_exponential;  ///< of a texture of gloss
};

struct ChosenLobe {
  LobeForm form;
  double error = 0;     ///< proven, in exact arithmetic
  double rounding = 0;  ///< added by the precision
  std::string reason;   ///< why it is the cheapest: "the best Gaussian, x = 0.3, is off by 0.02"
};

/// Tries the forms by rising cost, with EXP2 and LOG2 counted as four instructions each: a constant;
/// multiplications for one whole power; a Gaussian (5) without or with an offset; two slopes (7), three (8)
/// and four (9); and the power itself (9). Four slopes avoid LOG2: near 1 a GPU's LOG2 has an absolute error
/// of 2^-21 by the Vulkan specification, and the power multiplies it. `lobes` has at least one.
/// The constants are those with the smallest largest error, over all powers from the least to the largest.
ChosenLobe choose_lobe(const Lobes& lobes, const LobeBudget& budget, const Checkpoint& checkpoint);

}  // namespace shadefit::scene
