#include "fit/exchange/beyond_infinity.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace shadefit {
namespace {

/// Steps of an exchange that converges do not multiply a parameter by this.
constexpr double much = 1000;
/// Neighbouring scales: the exchange itself finds the rest of the way.
constexpr double scale_step = 8;
/// Nearer to infinity the parameters hardly move the level one by one. So the smallest ones count whose level
/// is not far above the least.
constexpr double near_least = 2;

/// How many times larger a parameter became. 0 if it has no size.
double growth(double from, double to) {
  if (to == 0 || !std::isfinite(to)) return 0;
  return std::abs(to) / std::abs(from);
}

}  // namespace

std::optional<std::vector<double>> beyond_infinity(
    const std::vector<double>& start, const std::vector<double>& end,
    const std::function<double(const std::vector<double>&)>& level) {
  double largest = 0;
  for (std::size_t i = 0; i < start.size(); ++i) {
    if (start[i] != 0) largest = std::max(largest, growth(start[i], end[i]));
  }
  if (!(largest > much)) return std::nullopt;

  std::vector<std::vector<double>> sides;
  std::vector<double> levels;
  for (double scale = 1; scale < largest; scale *= scale_step) {
    std::vector<double>& side = sides.emplace_back(end);
    for (std::size_t i = 0; i < end.size(); ++i) {
      if (growth(start[i], end[i]) > much) side[i] = -end[i] / scale;
    }
    levels.push_back(level(side));
  }
  const double least = *std::min_element(levels.begin(), levels.end());
  for (std::size_t i = sides.size(); i-- > 0;) {
    if (levels[i] <= near_least * least && std::isfinite(levels[i])) return std::move(sides[i]);
  }
  return std::nullopt;
}

}  // namespace shadefit
