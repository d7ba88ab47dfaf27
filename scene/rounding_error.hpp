#pragma once

#include <span>
#include <string_view>

#include "scene/lobe_form.hpp"
#include "scene/shown_scale.hpp"

/// What a processor's rounding adds to the error of a scene's shading.
namespace shadefit::scene {

enum class PixelPrecision { float32, float16 };

/// "float" or "half".
std::string_view name(PixelPrecision precision);

/// An upper bound for floats of what rounding moves on the scale, for lobes with factors up to `factor` and a
/// sharpness A = (n + x)/ln 2 up to `sharpness`.
///
/// Each operation is off by a factor 1 + u, u = 2^-24, exp2 and log2 by 2 ulps, 4 u. The exponent is
/// a = A y (s1 + y ..) with 2 d + 3 roundings, of the pixel's power two more; 2^a is off by ln 2 |a| times
/// that, and what is shown by v ln 2 |a| (2 d + 5) u, v = min(1, g 2^-|a|): most at |a| = log2 g or 1/ln 2.
/// The rest, F, the normalisation and the products, has 14 roundings. A c - A rounds A c: |A| u ln 2 more.
double float_rounding(const LobeForm& form, double factor, double sharpness, ShownScale scale);

/// For halves: every half c in [0, 1] and every lobe is tried, in Eigen::half with functions rounded once, in
/// the order of the generated code, its constants rounded to halves.
double half_rounding(const LobeForm& form, std::span<const WeightedPower> lobes, ShownScale scale);

}  // namespace shadefit::scene
