#include "scene/plan/lobe_error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace shadefit::scene {
namespace {

/// The largest shown error by brute force: many c, and many factors and slants of the light up to the
/// largest.
double brute_error(const WeightedPower& lobe, const std::vector<double>& slopes, double offset,
                   ShownScale scale) {
  double largest = 0;
  const double power = lobe.power.most;
  constexpr int steps = 4000, factors = 100;
  for (int i = 0; i <= steps; ++i) {
    // half of the cosines near the peak, where a sharp lobe lives, half everywhere
    const double y = i % 2 == 0 ? std::min(1.0, i * 0.01 / power) : static_cast<double>(i) / steps;
    const double target = std::pow(1 - y, power);
    const double form =
        planned_lobe<double>({.kind = LobeKind::exponential}, 1 - y, {slopes, power + offset});
    for (int j = 1; j <= factors; ++j) {
      const double g = lobe.factor * std::min(1.0, 2 * (1 - y)) * j / factors;
      largest = std::max(largest, std::abs(on_scale(scale, g * form) - on_scale(scale, g * target)));
    }
  }
  return largest;
}

TEST(LobeError, OfAGaussianIsTheLargestThatIsShown) {
  const std::vector<double> slope{natural_slope};
  const LobeCells cells(slope, 1e5);
  for (const double power : {0.25, 1.0, 2.5, 16.0, 300.0, 1e5}) {
    for (const double reflectance : {0.01, 0.3, 1.0}) {
      const double factor = reflectance * (power + 2) / 8;
      for (const double offset : {0.0, 0.775}) {
        for (const ShownScale scale : {ShownScale::linear, ShownScale::codes}) {
          const WeightedPower lobe{{power, power}, factor};
          SCOPED_TRACE(std::to_string(power) + " " + std::to_string(factor) + " " + std::to_string(offset));
          const double truth = brute_error(lobe, slope, offset, scale);
          const double proven = cells.largest_error(lobe, offset, scale, 0);
          EXPECT_GE(proven, truth);
          // cells are 2 % wide in t, at t up to 3 that is 6 %, in codes near black twice that; a hundred
          // factors miss the worst by a percent
          EXPECT_LE(proven, 1.15 * truth);
          EXPECT_EQ(cells.largest_error(lobe, offset, scale, 2 * proven), 2 * proven) << "enough is enough";
          for (const double share : {0.5, 0.9, 0.999})
            EXPECT_EQ(cells.largest_error(lobe, offset, scale, share * proven), proven)
                << "what is left out for " << share << " of it cannot matter";
        }
      }
    }
  }
}

TEST(LobeError, OfSlopesIsTheLargestThatIsShown) {
  const std::vector<std::vector<double>> forms{{1.4418, -1.00729}, {1.44304, -0.592018, 1.24132}};
  for (const auto& slopes : forms) {
    const LobeCells cells(slopes, 1e5);
    for (const WeightedPower& lobe : {WeightedPower{{0.5, 0.5}, 0.3}, WeightedPower{{4, 4}, 0.75},
                                      WeightedPower{{64, 64}, 8}, WeightedPower{{3000, 3000}, 400}}) {
      SCOPED_TRACE(lobe.power.most);
      const double truth = brute_error(lobe, slopes, 0, ShownScale::linear);
      const double proven = cells.largest_error(lobe, 0, ShownScale::linear, 0);
      EXPECT_GE(proven, truth);
      // where slopes and logarithm nearly agree, a cell holds a change of sign
      EXPECT_LE(proven, 1.25 * truth);
    }
  }
}

// A texture may hold anything between two powers: their bound is above that of each.
TEST(LobeError, OfAllPowersBetweenTwo) {
  const std::vector<double> slope{natural_slope};
  const LobeCells cells(slope, 1e5);
  for (const Range range : {Range{0, 0.01}, {0.3, 0.31}, {8, 8.2}, {300, 309}}) {
    const double factor = 0.5 * (range.most + 2) / 8;
    for (const double offset : {0.0, 0.5}) {
      const double all = cells.largest_error({range, factor}, offset, ShownScale::linear, 0);
      for (const double share : {0.0, 0.4, 1.0}) {
        const double power = range.least + share * (range.most - range.least);
        const double one =
            cells.largest_error(WeightedPower{{power, power}, factor}, offset, ShownScale::linear, 0);
        EXPECT_GE(all, one) << power;
        // 3 % of n move t by as much, on both sides
        EXPECT_LE(all, 1.25 * one + 0.004) << power;
      }
    }
  }
}

}  // namespace
}  // namespace shadefit::scene
