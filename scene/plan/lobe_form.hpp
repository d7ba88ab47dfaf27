#pragma once

#include <numbers>
#include <optional>
#include <vector>

#include "approx/arithmetic.hpp"
#include "approx/gloss.hpp"
#include "approx/shading.hpp"
#include "scene/materials/material.hpp"

/// The forms that can replace the lobe c^n of a scene.
namespace shadefit::scene {

enum class LobeKind {
  constant,     ///< 1: every power is 0
  multiplied,   ///< c^n by multiplications, for one common whole power
  exponential,  ///< exp2((n + x) y (s1 + y (s2 + ..))), y = c - 1
  power,        ///< exp2(n log2(c))
};

/// A form with its constants, if any.
struct LobeForm {
  LobeKind kind = LobeKind::power;
  int whole = 0;                    ///< the power of `multiplied`
  double offset = 0;                ///< x of `exponential`, at least 0; 0 with several slopes
  std::vector<double> slopes = {};  ///< of `exponential`; several slopes are floats
  /// For one slope and constant powers: true for A c - A, a multiply-add, if its rounding is acceptable;
  /// false for A (c - 1).
  bool is_fused = false;
  bool operator==(const LobeForm&) const = default;
};

/// The slope of the Gaussian that is c^n near the peak.
inline constexpr double natural_slope = std::numbers::log2e;

/// The parts of a lobe that do not depend on its cosine.
template <class T>
struct LobeConstants {
  std::vector<T> slopes;      ///< multiplied by n + x, or not
  std::optional<T> exponent;  ///< n + x, if the slopes do not include it; for `power` always n
};

/// The lobe of a form, as in the generated code.
template <class T>
T planned_lobe(const LobeForm& form, const T& cos_theta, const LobeConstants<T>& constants) {
  switch (form.kind) {
    case LobeKind::constant:
      break;
    case LobeKind::multiplied:
      return power(cos_theta, form.whole);
    case LobeKind::power:
      return power_by_exp2(cos_theta, *constants.exponent);
    case LobeKind::exponential:
      if (constants.exponent) return sloped_lobe(cos_theta, *constants.exponent, constants.slopes);
      return form.is_fused ? gaussian_lobe_base_two(cos_theta, constants.slopes.front())
                           : sloped_lobe(cos_theta, constants.slopes);
  }
  return integer<T>(1);
}

/// Lobes of a scene: their powers, and the largest factor in front of any of them.
struct WeightedPower {
  Range power;
  double factor;  ///< the largest F (n + 2)/8
  bool operator==(const WeightedPower&) const = default;
};

}  // namespace shadefit::scene
