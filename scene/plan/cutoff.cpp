#include "scene/plan/cutoff.hpp"

#include <algorithm>
#include <cmath>

#include "scene/plan/lobes.hpp"

namespace shadefit::scene {
namespace {

/// The least of (s (n + 2))^(-1/(n + shift)) over a range of powers, 1 at most. Its logarithm's slope has the
/// sign of log(s (n + 2)) - (n + shift)/(n + 2), which rises with n: so the function falls to a single
/// minimum and then rises.
double least_root(double s, double shift, const Range& powers) {
  const auto rises = [&](double n) { return std::log(s * (n + 2)) > (n + shift) / (n + 2); };
  double n = powers.least, high = powers.most;
  for (double middle = n; !rises(n) && (middle = n + (high - n) / 2) > n && middle < high;)
    (rises(middle) ? high : n) = middle;
  return n + shift > 0 ? std::min(1.0, std::exp(-std::log(s * (n + 2)) / (n + shift))) : 0;
}

}  // namespace

/// A light adds at most g min(1, 2c) c^n, g = F (n + 2)/8. This is at most e for c below (e/g)^(1/n), and for
/// c below (e/(2 g))^(1/(n + 1)). The larger of both is at least the larger of their minima.
double cutoff_of(double error, const Material& material) {
  const double per_error = largest_reflectance(material) / 8 / error;
  const Range powers = powers_of(material);
  return std::max(least_root(2 * per_error, 1, powers), least_root(per_error, 0, powers)) * downwards;
}

}  // namespace shadefit::scene
