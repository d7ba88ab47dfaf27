#pragma once

/// The scale of a displayed value: linear light or display codes.
///
/// The encoding is concave and 0 at 0. So the codes of two values that differ by d differ by at most the code
/// of d. Errors of several terms or lights therefore add up on this scale as on the linear one.
namespace shadefit::scene {

enum class ShownScale {
  linear,  ///< values in [0, 1]
  codes,   ///< sRGB codes of 8 bits, not rounded, in [0, 255]
};

/// A value in [0, 1] on the scale.
double on_scale(ShownScale scale, double linear);

/// The value in [0, 1] that is `shown` on the scale.
double from_scale(ShownScale scale, double shown);

/// An upper bound of the difference on the scale between a value up to `value` and that value times
/// e^-|log_ratio|.
double apart_by_ratio(ShownScale scale, double value, double log_ratio);

}  // namespace shadefit::scene
