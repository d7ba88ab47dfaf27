#include "scene/plan/shown_scale.hpp"

#include <algorithm>
#include <cmath>

#include "approx/encoding.hpp"

namespace shadefit::scene {
namespace {

constexpr double codes_of_white = 255;

/// v S'(v) of the encoding S rises with v, so two values with a given ratio differ most nearest to 1. But v
/// S'(v) falls once, where the curve leaves the straight line, from 12.92 v = 0.04045 to 1.055/2.4 v^(1/2.4)
/// = 0.03976, by 1.7 %. This factor covers that.
constexpr double kink = 1.018;

/// The two branches of the encoding do not meet: 12.92 0.0031308 = 0.040449936, the power there 0.0404499075,
/// 7.3e-6 codes less. This is the size of that step.
constexpr double step_down = 7.3e-6;

}  // namespace

double on_scale(ShownScale scale, double linear) {
  return scale == ShownScale::linear ? std::min(linear, 1.0) : srgb_code(linear);
}

double from_scale(ShownScale scale, double shown) {
  if (scale == ShownScale::linear) return std::min(shown, 1.0);
  return srgb_decode(std::min(shown / codes_of_white, 1.0));
}

double apart_by_ratio(ShownScale scale, double value, double log_ratio) {
  const double most = std::min(value, 1.0), distance = std::abs(log_ratio);
  if (scale == ShownScale::linear) return -std::expm1(-distance) * most;
  if (distance == 0) return 0;
  return kink * (on_scale(scale, most) - on_scale(scale, most * std::exp(-distance))) + step_down;
}

}  // namespace shadefit::scene
