#pragma once

#include <string>

#include "fit/support/checkpoint.hpp"
#include "scene/plan/lobes.hpp"
#include "scene/plan/rounding_error.hpp"
#include "scene/plan/shown_scale.hpp"

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
  /// Of a form with constants of its own: the mean error of what is shown, over the scene's powers by how
  /// often each is used, and that of the constants whose largest error is least; else 0.
  double mean_error = 0, mean_error_of_level = 0;
  int fits_run = 0;
  std::string cheaper = {};  ///< why no cheaper one: "a Gaussian is off by 0.02"; empty where there is none
};

/// The fits of lobes that there may be: an offset, and two, three or four slopes, by the largest error; and
/// of that form which is taken by the mean error.
inline constexpr int lobe_fits = 5;

/// By rising cost, EXP2 and LOG2 counted as four instructions each: a constant, multiplications for one whole
/// power, a Gaussian (5) without or with an offset, two slopes (7), three (8) and four (9, which saves LOG2:
/// near 1 that of a GPU has an absolute error of 2^-21 by the Vulkan specification, and the power multiplies
/// it), and the power itself (9). `lobes` has at least one.
///
/// A form is near enough if the constants of the least largest error over all powers between the least and
/// the largest are. What is then left of the budget goes to the mean error over the powers that are used, by
/// the share of the texels that use them: constants move as far from those towards the ones of the least mean
/// error as the proven bound allows, without a dearer exp2.
ChosenLobe choose_lobe(const Lobes& lobes, const LobeBudget& budget, const Checkpoint& checkpoint);

}  // namespace shadefit::scene
