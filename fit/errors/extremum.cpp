#include "fit/errors/extremum.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "fit/support/root.hpp"

namespace shadefit {

std::vector<double> search_points() {
  constexpr int cells = 256;
  constexpr int powers = 40;
  std::vector<double> points;
  for (int j = powers; j > 9; --j) points.push_back(std::ldexp(1.0, -j));
  for (int i = 0; i < cells; ++i) points.push_back((i + 0.5) / cells);
  for (int j = 10; j <= powers; ++j) points.push_back(1 - std::ldexp(1.0, -j));
  return points;
}

double largest_sampled(const std::function<double(double)>& f) {
  // Every fourth place: these functions are expensive, and the refinement covers the places between.
  std::vector<double> points{0};
  const std::vector<double> all = search_points();
  for (std::size_t i = 0; i < all.size(); i += 4) points.push_back(all[i]);
  points.push_back(1);
  std::vector<double> values;
  for (const double s : points) values.push_back(f(s));
  const auto best = static_cast<std::size_t>(std::ranges::max_element(values) - values.begin());
  const std::size_t left = best == 0 ? 0 : best - 1, right = std::min(best + 1, points.size() - 1);
  std::uintmax_t steps = 50;
  const auto refined = boost::math::tools::brent_find_minima([&](double s) { return -f(s); }, points[left],
                                                             points[right], 26, steps);
  return std::max(values[best], -refined.second);
}

Extremum largest_magnitude(const SearchedFunction& f, const Substitution& substitution) {
  using Jet = SearchedFunction::Jet;
  const auto slope = [&](double s) { return f.slope(substitution.at(Jet(s, 0)).cosine); };

  std::vector<Extremum> found;
  const auto consider = [&](double s) {
    const Cosine<double> at = substitution.at(s).cosine;
    found.push_back({std::abs(f.value(at)), at});
  };

  consider(0);
  const std::vector<double> points = search_points();
  double left = points.front(), left_slope = slope(left);
  for (const double right : points) {
    const double right_slope = slope(right);
    if (left_slope * right_slope < 0) {
      // 53 bits: the root is then as exact as f' itself.
      consider(root_between(slope, left, right, left_slope, right_slope, 53));
    } else if (right_slope == 0) {
      consider(right);
    }
    left = right;
    left_slope = right_slope;
  }
  consider(1);

  const double largest = std::ranges::max_element(found, {}, &Extremum::magnitude)->magnitude;
  Extremum chosen{largest, {2, -1}};
  for (const Extremum& candidate : found) {
    const bool is_equal = candidate.magnitude >= largest * (1 - equal_extrema);
    if (is_equal && candidate.at.cos_theta < chosen.at.cos_theta) chosen.at = candidate.at;
  }
  return chosen;
}

}  // namespace shadefit
