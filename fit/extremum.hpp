#pragma once

#include <algorithm>
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

/// Magnitudes this close to the largest count as equal to it, relative; the smallest c among them is the
/// place reported.
inline constexpr double equal_extrema = 1e-9;

/// Where a sampled search looks: 256 even places inside (0, 1), and towards either end powers of two, so that
/// a spike as narrow as 1e-12 of the domain is seen there.
inline std::vector<double> search_points() {
  constexpr int cells = 256;
  constexpr int powers = 40;
  std::vector<double> points;
  for (int j = powers; j > 9; --j) points.push_back(std::ldexp(1.0, -j));
  for (int i = 0; i < cells; ++i) points.push_back((i + 0.5) / cells);
  for (int j = 10; j <= powers; ++j) points.push_back(1 - std::ldexp(1.0, -j));
  return points;
}

/// The largest |f| over the domain of the substitution. Sampled: sign changes of f' are looked for between
/// the `search_points` and refined to a root; both ends count. `f` maps a Cosine<T> to a T, for double and
/// ceres::Jet<double, 1>.
template <class F>
Extremum largest_magnitude(const F& f, const Substitution& substitution) {
  using Jet = ceres::Jet<double, 1>;
  const auto slope = [&](double s) { return f(substitution.at(Jet(s, 0)).cosine).v[0]; };

  std::vector<Extremum> found;
  const auto consider = [&](double s) {
    const Cosine<double> at = substitution.at(s).cosine;
    found.push_back({std::abs(f(at)), at});
  };

  consider(0);
  const std::vector<double> points = search_points();
  double left = points.front(), left_slope = slope(left);
  for (const double right : points) {
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

  const auto by_magnitude = [](const Extremum& a, const Extremum& b) { return a.magnitude < b.magnitude; };
  const double largest = std::max_element(found.begin(), found.end(), by_magnitude)->magnitude;
  Extremum chosen{largest, {2, -1}};
  for (const Extremum& candidate : found) {
    const bool is_equal = candidate.magnitude >= largest * (1 - equal_extrema);
    if (is_equal && candidate.at.cos_theta < chosen.at.cos_theta) chosen.at = candidate.at;
  }
  return chosen;
}

}  // namespace shadefit
