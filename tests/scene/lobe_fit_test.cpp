#include "scene/plan/lobe_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/scene/one_lobe.hpp"

namespace shadefit::scene {
namespace {

TEST(LobeFit, TheBestOffsetIsBest) {
  const std::vector<WeightedPower> lobes{of_power(8, 0.5), of_power(40, 1.5)};
  LobeFitter fitter(lobes, ShownScale::linear);
  EXPECT_EQ(fitter.fits_run(), 0);
  const double best = fitter.best_offset();
  EXPECT_EQ(fitter.fits_run(), 1);
  const std::vector<double> slope{natural_slope};
  // found to 1e-4
  for (const double other : {best - 2e-4, best + 2e-4})
    EXPECT_LT(fitter.sampled_error(slope, best), fitter.sampled_error(slope, other));
}

TEST(LobeFit, AnErrorIsLookedForNoFurtherThanAsked) {
  const LobeFitter fitter(std::vector{of_power(8, 0.5), of_power(40, 1.5), of_power(900, 100)},
                          ShownScale::linear);
  const std::vector<double> slope{natural_slope};
  for (const double offset : {0.0, 0.7, 5.0}) {
    const double whole = fitter.sampled_error(slope, offset);
    EXPECT_EQ(fitter.sampled_error(slope, offset, whole), whole) << offset;
    for (const double share : {0.1, 0.5, 0.99}) {
      const double some = fitter.sampled_error(slope, offset, share * whole);
      EXPECT_GT(some, share * whole) << offset;
      EXPECT_LE(some, whole) << offset;
    }
  }
}

// The error of the best is level: it is as large at slopes + 1 places, of alternating sign.
TEST(LobeFit, TheBestSlopesAreBest) {
  const std::vector<WeightedPower> lobes{of_power(16, 0.1)};
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
  EXPECT_EQ(fitter.fits_run(), 3);
}

/// The mean square by brute force: all cosines alike, each used power by its share, and of all lights up to
/// the strongest the one that shows most.
double brute_mean(const std::vector<UsedPower>& used, const LobeForm& form, ShownScale scale) {
  constexpr int steps = 20000, lights = 50;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double c = (i + 0.5) / steps, y = 1 - c;
    double exponent = 0;
    for (std::size_t j = form.slopes.size(); j > 0; --j) exponent = -y * (form.slopes[j - 1] + exponent);
    for (const UsedPower& one : used) {
      const double made = std::exp2((one.power + form.offset) * exponent), target = std::pow(c, one.power);
      double largest = 0;
      for (int light = 1; light <= lights; ++light) {
        const double g = one.factor * std::min(1.0, 2 * c) * light / lights;
        largest = std::max(largest, std::abs(shown_value(scale, g * made) - shown_value(scale, g * target)));
      }
      sum += one.share * largest * largest;
    }
  }
  return std::sqrt(sum / steps);
}

const std::vector<UsedPower> mostly_blunt{{8, 0.05, 0.9}, {100, 2, 0.1}};
const std::vector<UsedPower> mostly_sharp{{8, 0.05, 0.1}, {100, 2, 0.9}};

// The truth is summed without the fitter's places.
TEST(LobeFit, TheMeanErrorIsThatOfWhatIsShown) {
  const std::vector<WeightedPower> lobes{of_power(8, 0.05), of_power(100, 2)};
  for (const ShownScale scale : {ShownScale::linear, ShownScale::codes}) {
    for (const auto& used : {mostly_blunt, mostly_sharp}) {
      LobeFitter fitter(lobes, scale, used);
      (void)fitter.best_on_the_mean({.slopes = {natural_slope}});
      for (const LobeForm& form : {LobeForm{.offset = 0.3, .slopes = {natural_slope}},
                                   LobeForm{.offset = 0, .slopes = {1.4418, -1.00729}}}) {
        const double truth = brute_mean(used, form, scale);
        // places are 5 % apart, and in codes the difference that is shown is a bound, 3 % above it
        EXPECT_NEAR(fitter.mean_error(form) / truth, 1, scale == ShownScale::linear ? 0.05 : 0.08)
            << form.slopes.size() << " slopes, truth " << truth;
      }
    }
  }
}

TEST(LobeFit, TheBestOnTheMeanIsBest) {
  const std::vector<WeightedPower> lobes{of_power(8, 0.05), of_power(100, 2)};
  std::vector<std::vector<double>> found;
  for (const auto& used : {mostly_blunt, mostly_sharp}) {
    LobeFitter fitter(lobes, ShownScale::linear, used);
    const LobeForm gaussian = fitter.best_on_the_mean({.slopes = {natural_slope}});
    const LobeForm sloped = fitter.best_on_the_mean({.slopes = {natural_slope, -0.7, 0.5}});
    EXPECT_EQ(fitter.fits_run(), 2);
    EXPECT_LT(fitter.mean_error(sloped), fitter.mean_error(gaussian) / 4);
    // steps that are weighed anew come within some percent of the least
    for (const double sign : {-1.0, 1.0}) {
      LobeForm other = gaussian;
      other.offset += sign * 0.1;
      EXPECT_GT(fitter.mean_error(other), 0.97 * fitter.mean_error(gaussian)) << sign;
      for (std::size_t i = 0; i < 3; ++i) {
        other = sloped;
        other.slopes[i] += sign * 0.01;
        EXPECT_GT(fitter.mean_error(other), 0.97 * fitter.mean_error(sloped)) << i << " " << sign;
      }
    }
    found.push_back({gaussian.offset, sloped.slopes[1]});
  }
  // what is used decides
  EXPECT_GT(std::abs(found[0][0] - found[1][0]), 1e-3);
  EXPECT_GT(std::abs(found[0][1] - found[1][1]), 1e-3);
}

// An offset below 0 would make a form above 1 of a power of 0.
TEST(LobeFit, NoOffsetIsBelowZero) {
  const std::vector<UsedPower> bright{{1000, 1e6, 1}};
  LobeFitter fitter(std::vector{of_power(1000, 1e6)}, ShownScale::linear, bright);
  EXPECT_GE(fitter.best_on_the_mean({.slopes = {natural_slope}}).offset, 0);
}

TEST(LobeFit, ThousandsAreThinnedOut) {
  std::vector<WeightedPower> lobes;
  for (int i = 0; i < 5000; ++i) lobes.push_back(of_power(10 + i * 0.001, 1));
  lobes[2500].factor = 1.5;
  LobeFitter many(lobes, ShownScale::linear), few(std::vector{lobes[2500]}, ShownScale::linear);
  EXPECT_NEAR(many.best_offset(), few.best_offset(), 0.02);

  std::vector<UsedPower> used;
  for (int i = 0; i < 5000; ++i) used.push_back({10 + i * 0.001, 1, 1.0 / 5000});
  LobeFitter together(lobes, ShownScale::linear, used);
  LobeFitter alone(lobes, ShownScale::linear, std::vector{UsedPower{12.5, 1, 1}});
  const LobeForm gaussian{.slopes = {natural_slope}};
  EXPECT_NEAR(together.best_on_the_mean(gaussian).offset, alone.best_on_the_mean(gaussian).offset, 0.02);
}

TEST(LobeFit, OfDullLobesToo) {
  for (const double power : {1e-3, 0.04, 0.3}) {
    LobeFitter fitter(std::vector{of_power(0, 0.25), of_power(power, (power + 2) / 8)}, ShownScale::linear);
    for (int count = 2; count <= 4; ++count) {
      for (const double slope : fitter.best_slopes(count)) EXPECT_LT(std::abs(slope), 100) << power;
    }
    EXPECT_GE(fitter.best_offset(), 0);
  }
}

}  // namespace
}  // namespace shadefit::scene
