#pragma once

#include <cmath>
#include <numbers>
#include <vector>

/// What may stand for the lobe c^n of a scene.
namespace shadefit::scene {

enum class LobeKind {
  constant,     ///< 1: every power is 0
  multiplied,   ///< c^n by multiplications, one whole power for all
  exponential,  ///< exp2((n + x) y (s1 + y (s2 + ..))), y = c - 1
  power,        ///< exp2(n log2(c))
};

/// A form, and its constants where it has some.
struct LobeForm {
  LobeKind kind = LobeKind::power;
  int whole = 0;                    ///< of `multiplied`
  double offset = 0;                ///< x of `exponential`, at least 0; 0 where there are several slopes
  std::vector<double> slopes = {};  ///< of `exponential`: each a float
  /// Of one slope: A c - A, a multiply-add, where it rounds well enough; else A (c - 1).
  bool is_fused = false;
  bool operator==(const LobeForm&) const = default;
};

/// The slope of the Gaussian that is c^n near the peak.
inline constexpr double natural_slope = std::numbers::log2e;

/// A lobe of a scene: the power, and the largest factor in front of it.
struct WeightedPower {
  double power;
  double factor;  ///< the largest F (n + 2)/8
  bool operator==(const WeightedPower&) const = default;
};

}  // namespace shadefit::scene
