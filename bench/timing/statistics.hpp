#pragma once

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <vector>

/// What a list of samples says: its middle, and how far half of it lies apart.
namespace shadefit::bench {

struct Spread {
  double median;
  double lower_quartile, upper_quartile;

  /// The interquartile range: the width of the middle half of the samples.
  double width() const { return upper_quartile - lower_quartile; }
};

/// The value below which a share of the samples lies, between two of them by a straight line: the first one
/// at share 0, the last at 1. The samples are sorted, and not none.
inline double quantile(const std::vector<double>& sorted, double share) {
  const double rank = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(rank);
  const auto above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (rank - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

/// Median and quartiles of one sample or more. Throws std::invalid_argument for none.
inline Spread spread_of(std::vector<double> samples) {
  if (samples.empty()) throw std::invalid_argument("no samples have no median");
  std::sort(samples.begin(), samples.end());
  return {quantile(samples, 0.5), quantile(samples, 0.25), quantile(samples, 0.75)};
}

}  // namespace shadefit::bench
