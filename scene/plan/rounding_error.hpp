#pragma once

#include <string_view>

#include "scene/plan/lobes.hpp"
#include "scene/plan/shown_scale.hpp"

/// Bounds of the rounding error of a scene's shading, by counting roundings.
///
/// An operation has an error factor of at most 1 + u, u = 2^-24 or 2^-11. In float, exp2 and log2 have 4
/// ulps, 8 u; in half one rounding, because a processor computes them in float. Between 1/2 and 2 log2 has an
/// absolute error of 2^-21 instead, so c^n one of n ln 2 times that, relative. The displayed value of a light
/// is v = min(1, g w 2^-|a|), a the exponent of the lobe.
///
/// - The exponent of d slopes has 2 d + 3 roundings, with n + x and the constants; A c - A rounds A c, |A| u
///   more; where slopes differ in sign and cancel, all times by how much. 2^a is off by ln 2 |a| times that,
///   and v |a| is largest at |a| = log2 g, or at 1/ln 2 where g is below 2.
/// - n of a pixel: 2/alpha^2 - 2 of alpha = r^2 is off by 5 u (n + 2), 2^(10 g + 1) by 20 u n, in the
/// exponent
///   and in (n + 2)/8. Of a power below 1 the exponent is |log2 c| times that, with w <= 2 c before it.
/// - F0 + (F90 - F0) (1 - l.h)^5 has 12 roundings at most, of which the power makes 8, F0 alone 1; the
///   normalisation 3, the products with it, n.l and the exp2 7.
namespace shadefit::scene {

enum class PixelPrecision { float32, float16 };

/// "float" or "half".
std::string_view name(PixelPrecision precision);

/// The shading whose rounding is bounded.
struct RoundedShading {
  const LobeForm& form;
  const Lobes& lobes;
  bool has_fresnel;
  bool is_gloss_exponential;  ///< of a texture of gloss
};

/// A bound of the rounding error of a light's result on the scale. It is white if the format cannot hold a
/// number: a power or a normalisation above the largest half.
double rounding_error(const RoundedShading& shading, PixelPrecision precision, ShownScale scale);

}  // namespace shadefit::scene
