#include "scene/plan/lobe_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace shadefit::scene {
namespace {

TEST(LobeFit, TheBestOffsetIsBest) {
  const std::vector<WeightedPower> lobes{WeightedPower{{8, 8}, 0.5}, WeightedPower{{40, 40}, 1.5}};
  const LobeFitter fitter(lobes, ShownScale::linear);
  const double best = fitter.best_offset();
  const std::vector<double> slope{natural_slope};
  for (const double other : {best - 2e-4, best + 2e-4})  // found to 1e-4
    EXPECT_LT(fitter.sampled_error(slope, best), fitter.sampled_error(slope, other));
}

// The error of the best is level: it is as large at slopes + 1 places, of alternating sign.
TEST(LobeFit, TheBestSlopesAreBest) {
  const std::vector<WeightedPower> lobes{WeightedPower{{16, 16}, 0.1}};
  LobeFitter fitter(lobes, ShownScale::linear);
  double before = fitter.sampled_error(std::vector{natural_slope}, 0);
  for (int count = 2; count <= 4; ++count) {
    const std::vector<double> slopes = fitter.best_slopes(count);
    ASSERT_EQ(slopes.size(), static_cast<std::size_t>(count));
    const double error = fitter.sampled_error(slopes, 0);
    EXPECT_LT(error, before / 4) << "each slope is worth its multiply-add";
    for (std::size_t i = 0; i < slopes.size(); ++i) {
      EXPECT_EQ(slopes[i], static_cast<double>(static_cast<float>(slopes[i])));
      for (const double change : {-0.02, 0.02}) {
        std::vector<double> other = slopes;
        other[i] += change;
        // the exchange is of a linearised error, within some percent of the minimax
        EXPECT_GT(fitter.sampled_error(other, 0), 0.97 * error) << count << " " << i;
      }
    }
    before = error;
  }
}

TEST(LobeFit, ThousandsAreThinnedOut) {
  std::vector<WeightedPower> lobes;
  for (int i = 0; i < 5000; ++i) lobes.push_back(WeightedPower{{10 + i * 0.001, 10 + i * 0.001}, 1});
  lobes[2500].factor = 1.5;
  const LobeFitter many(lobes, ShownScale::linear), few(std::vector{lobes[2500]}, ShownScale::linear);
  EXPECT_NEAR(many.best_offset(), few.best_offset(), 0.02);
}

TEST(LobeFit, OfDullLobesToo) {
  for (const double power : {1e-3, 0.04, 0.3}) {
    LobeFitter fitter(
        std::vector{WeightedPower{{0, 0}, 0.25}, WeightedPower{{power, power}, (power + 2) / 8}},
        ShownScale::linear);
    for (int count = 2; count <= 4; ++count) {
      for (const double slope : fitter.best_slopes(count)) EXPECT_LT(std::abs(slope), 100) << power;
    }
    EXPECT_GE(fitter.best_offset(), 0);
  }
}

}  // namespace
}  // namespace shadefit::scene
