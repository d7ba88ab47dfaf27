#pragma once

#include <algorithm>

#include "approx/encoding.hpp"
#include "scene/plan/lobe_form.hpp"
#include "scene/plan/shown_scale.hpp"

/// What the tests of a plan's lobes share.
namespace shadefit::scene {

/// The displayed value of a light: clamped, and on the scale.
inline double shown_value(ShownScale scale, double linear) {
  const double clamped = std::min(1.0, linear);
  return scale == ShownScale::linear ? clamped : srgb_code(clamped);
}

inline WeightedPower of_power(double power, double factor) {
  return {{power, power}, factor};
}

}  // namespace shadefit::scene
