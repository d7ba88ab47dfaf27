#include "scene/lobe_error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "approx/encoding.hpp"
#include "scene/lobe_fit.hpp"
#include "scene/rounding_error.hpp"

namespace shadefit::scene {
namespace {

/// What is shown of a light: clamped, and on the scale.
double shown_value(ShownScale scale, double linear) {
  const double clamped = std::min(1.0, linear);
  return scale == ShownScale::linear ? clamped : srgb_code(clamped);
}

/// The largest shown error by brute force: many c, and many factors and slants of the light up to the
/// largest.
double brute_error(const WeightedPower& lobe, const std::vector<double>& slopes, double offset,
                   ShownScale scale) {
  double largest = 0;
  constexpr int steps = 4000, factors = 100;
  for (int i = 0; i <= steps; ++i) {
    // half of the cosines near the peak, where a sharp lobe lives, half everywhere
    const double y = i % 2 == 0 ? std::min(1.0, i * 0.01 / lobe.power) : static_cast<double>(i) / steps;
    double exponent = 0;
    for (std::size_t j = slopes.size(); j > 0; --j) exponent = -y * (slopes[j - 1] + exponent);
    const double target = std::pow(1 - y, lobe.power), form = std::exp2((lobe.power + offset) * exponent);
    for (int j = 1; j <= factors; ++j) {
      const double g = lobe.factor * std::min(1.0, 2 * (1 - y)) * j / factors;
      largest = std::max(largest, std::abs(shown_value(scale, g * form) - shown_value(scale, g * target)));
    }
  }
  return largest;
}

std::string text_of(const WeightedPower& lobe, double offset) {
  return std::to_string(lobe.power) + " " + std::to_string(lobe.factor) + " " + std::to_string(offset);
}

TEST(LobeError, OfAGaussianIsTheLargestThatIsShown) {
  const std::vector<double> slope{natural_slope};
  const LobeCells cells(slope, 1e5);
  for (const double power : {0.25, 1.0, 2.5, 16.0, 300.0, 1e5}) {
    for (const double reflectance : {0.01, 0.3, 1.0}) {
      const double factor = reflectance * (power + 2) / 8;
      for (const double offset : {0.0, 0.775}) {
        for (const ShownScale scale : {ShownScale::linear, ShownScale::codes}) {
          const WeightedPower lobe{power, factor};
          const double truth = brute_error(lobe, slope, offset, scale);
          const double proven = cells.largest_error(lobe, offset, scale, 0);
          EXPECT_GE(proven, truth) << text_of(lobe, offset);
          // cells are 2 % wide in t, at t up to 3 that is 6 %, in codes near black twice that; a hundred
          // factors miss the worst by a percent
          EXPECT_LE(proven, 1.15 * truth) << text_of(lobe, offset);
          EXPECT_EQ(cells.largest_error(lobe, offset, scale, 2 * proven), 2 * proven) << "enough is enough";
        }
      }
    }
  }
}

TEST(LobeError, OfSlopesIsTheLargestThatIsShown) {
  const std::vector<std::vector<double>> forms{{1.4418, -1.00729}, {1.44304, -0.592018, 1.24132}};
  for (const auto& slopes : forms) {
    const LobeCells cells(slopes, 1e5);
    for (const WeightedPower lobe : {WeightedPower{0.5, 0.3}, {4, 0.75}, {64, 8}, {3000, 400}}) {
      const double truth = brute_error(lobe, slopes, 0, ShownScale::linear);
      const double proven = cells.largest_error(lobe, 0, ShownScale::linear, 0);
      EXPECT_GE(proven, truth) << text_of(lobe, 0);
      // where slopes and logarithm nearly agree, a cell holds a change of sign
      EXPECT_LE(proven, 1.25 * truth) << text_of(lobe, 0);
    }
  }
}

TEST(LobeFit, TheBestOffsetIsBest) {
  const std::vector<WeightedPower> lobes{{8, 0.5}, {40, 1.5}};
  LobeFitter fitter(lobes, ShownScale::linear);
  EXPECT_EQ(fitter.fits_run(), 0);
  const double best = fitter.best_offset();
  EXPECT_EQ(fitter.fits_run(), 1);
  const std::vector<double> slope{natural_slope};
  for (const double other : {best - 0.02, best + 0.02})
    EXPECT_LT(fitter.sampled_error(slope, best), fitter.sampled_error(slope, other));
}

// The error of the best is level: it is as large at slopes + 1 places, of alternating sign.
TEST(LobeFit, TheBestSlopesAreBest) {
  const std::vector<WeightedPower> lobes{{16, 0.1}};
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
        // Lawson's iteration comes within some percent of the minimax
        EXPECT_GT(fitter.sampled_error(other, 0), 0.97 * error) << count << " " << i;
      }
    }
    before = error;
  }
  EXPECT_EQ(fitter.fits_run(), 3);
}

TEST(LobeFit, ThousandsAreThinnedOut) {
  std::vector<WeightedPower> lobes;
  for (int i = 0; i < 5000; ++i) lobes.push_back({10 + i * 0.001, 1});
  lobes[2500].factor = 1.5;
  LobeFitter many(lobes, ShownScale::linear), few(std::vector{lobes[2500]}, ShownScale::linear);
  EXPECT_NEAR(many.best_offset(), few.best_offset(), 0.02);
}

TEST(ShownScale, ThereAndBack) {
  for (const double v : {0.0, 0.001, 0.0031308, 0.2, 1.0}) {
    for (const ShownScale scale : {ShownScale::linear, ShownScale::codes})
      EXPECT_NEAR(from_scale(scale, on_scale(scale, v)), v, 1e-6);
  }
  EXPECT_EQ(on_scale(ShownScale::linear, 3), 1);
  EXPECT_DOUBLE_EQ(on_scale(ShownScale::codes, 3), 255);
  EXPECT_EQ(from_scale(ShownScale::codes, 1000), 1);
}

// Of all values up to one, those nearest to it are farthest apart, but for the kink of the encoding.
TEST(ShownScale, ApartByARatio) {
  for (const double most : {0.002, 0.0032, 0.0035, 0.5, 1.0, 7.0}) {
    for (const double ratio : {1e-4, 0.01, 0.7}) {
      double largest = 0;
      for (int i = 1; i <= 2000; ++i) {
        const double v = std::min(most, 1.0) * i / 2000;
        largest = std::max(largest, srgb_code(v) - srgb_code(v * std::exp(-ratio)));
      }
      EXPECT_GE(apart_by_ratio(ShownScale::codes, most, ratio), largest);
      EXPECT_LE(apart_by_ratio(ShownScale::codes, most, -ratio), 1.03 * largest) << most << " " << ratio;
      EXPECT_EQ(apart_by_ratio(ShownScale::linear, most, ratio), std::min(most, 1.0) * -std::expm1(-ratio));
    }
  }
}

/// What floats make of a Gaussian, written as A c - A or as A (c - 1), beside exact ones of the same A.
double measured_rounding(const LobeForm& form, const WeightedPower& lobe) {
  const auto sharpness = static_cast<float>((lobe.power + form.offset) * form.slopes[0]);
  const auto factor = static_cast<float>(lobe.factor);
  double largest = 0;
  for (int i = 0; i <= 20000; ++i) {
    const auto c = static_cast<float>(1 - i * 0.002 / lobe.power);
    if (c < 0) break;
    const float exponent = form.is_fused ? sharpness * c - sharpness : sharpness * (c - 1);
    const float shown = std::min(1.0F, factor * std::exp2(exponent));
    const double exact = (lobe.power + form.offset) * form.slopes[0] * (static_cast<double>(c) - 1);
    largest = std::max(largest, std::abs(shown - std::min(1.0, lobe.factor * std::exp2(exact))));
  }
  return largest;
}

TEST(RoundingError, OfFloatsIsNotExceeded) {
  for (const bool is_fused : {false, true}) {
    for (const WeightedPower lobe : {WeightedPower{8, 0.05}, {200, 25}, {1e5, 1e4}}) {
      const LobeForm form{
          .kind = LobeKind::exponential, .offset = 0.7, .slopes = {natural_slope}, .is_fused = is_fused};
      const double sharpness = (lobe.power + form.offset) * natural_slope;
      const double bound = float_rounding(form, lobe.factor, sharpness, ShownScale::linear);
      EXPECT_LE(measured_rounding(form, lobe), bound) << is_fused << " " << lobe.power;
      if (is_fused && lobe.power > 100) {
        EXPECT_GE(measured_rounding(form, lobe), 0.1 * bound) << "A c - A does cancel";
      }
    }
  }
}

// Halves: 2^-11 of a value is half a code. A fused sharp lobe is noise, and one too bright for a half is
// lost.
TEST(RoundingError, OfHalvesIsTried) {
  LobeForm form{.kind = LobeKind::exponential, .slopes = {natural_slope}};
  const std::array dull{WeightedPower{8, 0.05}}, sharp{WeightedPower{500, 62.75}},
      bright{WeightedPower{1e6, 1e5}};
  EXPECT_LT(half_rounding(form, dull, ShownScale::linear), 0.05 / 256);
  EXPECT_GT(half_rounding(form, sharp, ShownScale::linear), 1.0 / 1024);
  const double apart = half_rounding(form, sharp, ShownScale::linear);
  form.is_fused = true;
  EXPECT_GT(half_rounding(form, sharp, ShownScale::linear), 20 * apart);
  EXPECT_EQ(half_rounding(form, bright, ShownScale::linear), 1);
  EXPECT_EQ(name(PixelPrecision::float16), "half");
}

}  // namespace
}  // namespace shadefit::scene
