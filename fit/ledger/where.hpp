#pragma once

#include <string>
#include <utility>
#include <vector>

#include "fit/errors/extremum.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/root.hpp"

/// The ranges in which a condition holds.
namespace shadefit {

/// The ranges of s in [0, 1] on which f is negative. Sampled: changes of its sign between the `search_points`
/// and both ends are refined by bisection; two changes within one cell are missed.
template <class F>
std::vector<std::pair<double, double>> where_negative(const F& f) {
  const auto is_inside = [&](double s) { return f(s) < 0; };
  std::vector<double> points = search_points();
  points.push_back(1);
  std::vector<std::pair<double, double>> ranges;
  double left = 0;
  bool inside = is_inside(left);
  if (inside) ranges.emplace_back(0, 1);
  for (const double right : points) {
    if (is_inside(right) != inside) {
      const double change =
          last_by_halving(left, right, 53, [&](double s) { return is_inside(s) == inside; });
      if (inside) {
        ranges.back().second = change;
      } else {
        ranges.emplace_back(change, 1);
      }
      inside = !inside;
    }
    left = right;
  }
  return ranges;
}

/// "from c = 0.1 to 0.2 and from c = 0.5 to 1", or "nowhere".
inline std::string ranges_in_words(const std::vector<std::pair<double, double>>& ranges, int digits) {
  std::vector<std::string> words;
  for (const auto& [from, to] : ranges)
    words.push_back("from c = " + decimal(from, digits) + " to " + decimal(to, digits));
  return words.empty() ? "nowhere" : enumerated(words);
}

}  // namespace shadefit
