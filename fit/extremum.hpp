#pragma once

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <vector>

#include "approx/cosine.hpp"
#include "fit/jet.hpp"
#include "fit/substitution.hpp"

/// Where a function of the cosine is largest in magnitude.
namespace shadefit {

struct Extremum {
  double magnitude = 0;
  Cosine<double> at{};
};

/// Magnitudes this close count as equal, relative; the extremum with the smallest c is then the one reported.
inline constexpr double equal_extrema = 1e-9;

/// The largest |f| over the domain of the substitution. Sampled: sign changes of f' are looked for between
/// 258 points and refined to a root; both ends count. `f` maps a Cosine<T> to a T, for double and
/// ceres::Jet<double, 1>.
template <class F>
Extremum largest_magnitude(const F& f, const Substitution& substitution) {
  using Jet = ceres::Jet<double, 1>;
  const auto slope = [&](double s) { return f(substitution.at(Jet(s, 0)).cosine).v[0]; };

  Extremum best;
  const auto consider = [&](double s) {
    const Cosine<double> at = substitution.at(s).cosine;
    const double magnitude = std::abs(f(at));
    const bool is_larger = magnitude > best.magnitude * (1 + equal_extrema);
    const bool is_equal = magnitude >= best.magnitude * (1 - equal_extrema);
    if (is_larger || (is_equal && at.cos_theta < best.at.cos_theta)) best = {magnitude, at};
  };

  constexpr int cells = 256;
  constexpr double near_end = 1.0 / (1 << 20);
  consider(0);
  double left = near_end, left_slope = slope(left);
  for (int i = 0; i <= cells; ++i) {
    const double right = i < cells ? (i + 0.5) / cells : 1 - near_end;
    const double right_slope = slope(right);
    if (left_slope * right_slope < 0) {
      // 53 bits: the root is then as exact as f' itself. Fifty steps bound what takes about ten.
      std::uintmax_t steps = 50;
      const auto root = boost::math::tools::toms748_solve(
          slope, left, right, left_slope, right_slope, boost::math::tools::eps_tolerance<double>(53), steps);
      consider((root.first + root.second) / 2);
    } else if (right_slope == 0) {
      consider(right);
    }
    left = right;
    left_slope = right_slope;
  }
  consider(1);
  return best;
}

}  // namespace shadefit
