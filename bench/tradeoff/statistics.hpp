#pragma once

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <vector>

/// The median and the spread of samples.
namespace shadefit::bench {

struct Spread {
  double median;
  double lower_quartile, upper_quartile;

  /// The interquartile range: the width of the middle half of the samples.
  double width() const { return upper_quartile - lower_quartile; }
};

/// The quantile of sorted samples, linear between two of them: the first at share 0, the last at 1. There is
/// at least one sample.
inline double quantile(const std::vector<double>& sorted, double share) {
  const double rank = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(rank);
  const auto above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (rank - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

/// Median and quartiles of at least one sample. Throws std::invalid_argument for none.
inline Spread spread_of(std::vector<double> samples) {
  if (samples.empty()) throw std::invalid_argument("no samples have no median");
  std::sort(samples.begin(), samples.end());
  return {quantile(samples, 0.5), quantile(samples, 0.25), quantile(samples, 0.75)};
}

}  // namespace shadefit::bench
