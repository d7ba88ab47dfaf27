#pragma once

/// On what scale a shown value counts: as light, or as a display's code.
///
/// The encoding is concave and 0 at 0. So values that are apart by d are apart by no more than the encoding
/// of d, and errors of several terms or lights add up on this scale as on the linear one.
namespace shadefit::scene {

enum class ShownScale {
  linear,  ///< values in [0, 1]
  codes,   ///< sRGB codes of 8 bits, not rounded, in [0, 255]
};

/// A value in [0, 1] on the scale.
double on_scale(ShownScale scale, double linear);

/// The value in [0, 1] that is `shown` on the scale.
double from_scale(ShownScale scale, double shown);

/// The largest difference on the scale of a value up to `value` and another that is smaller by the factor
/// e^-|log_ratio|: an upper bound.
double apart_by_ratio(ShownScale scale, double value, double log_ratio);

}  // namespace shadefit::scene
