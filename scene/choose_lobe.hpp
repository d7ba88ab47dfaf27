#pragma once

#include <string>

#include "fit/checkpoint.hpp"
#include "scene/lobes.hpp"
#include "scene/rounding_error.hpp"
#include "scene/shown_scale.hpp"

/// The cheapest form of the lobe that is near enough.
namespace shadefit::scene {

/// What a form may be off by, and how that is measured.
struct LobeBudget {
  double allowed;  ///< on the scale, of one light, rounding included
  ShownScale scale;
  PixelPrecision precision;
  bool has_fresnel;           ///< of what is rounded beside the lobe
  bool is_gloss_exponential;  ///< of a texture of gloss
};

struct ChosenLobe {
  LobeForm form;
  double error = 0;     ///< proven, in exact arithmetic
  double rounding = 0;  ///< what the precision adds
  int fits_run = 0;
  std::string cheaper = {};  ///< why no cheaper one: "a Gaussian is off by 0.02"; empty where there is none
};

/// The fits of lobes that there may be: an offset, and two, three or four slopes.
inline constexpr int lobe_fits = 4;

/// By rising cost, EXP2 and LOG2 counted as four instructions each: a constant, multiplications for one whole
/// power, a Gaussian (5) without or with an offset, two slopes (7), three (8) and four (9, which saves LOG2:
/// near 1 that of a GPU has an absolute error of 2^-21 by the Vulkan specification, and the power multiplies
/// it), and the power itself (9). `lobes` has at least one.
ChosenLobe choose_lobe(const Lobes& lobes, const LobeBudget& budget, const Checkpoint& checkpoint);

}  // namespace shadefit::scene
