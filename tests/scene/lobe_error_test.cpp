#include "scene/plan/lobe_error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "approx/encoding.hpp"
#include "fit/scalars/half.hpp"
#include "scene/plan/lobe_fit.hpp"
#include "scene/plan/rounding_error.hpp"

namespace shadefit::scene {
namespace {

/// The displayed value of a light: clamped, and on the scale.
double shown_value(ShownScale scale, double linear) {
  const double clamped = std::min(1.0, linear);
  return scale == ShownScale::linear ? clamped : srgb_code(clamped);
}

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
    double exponent = 0;
    for (std::size_t j = slopes.size(); j > 0; --j) exponent = -y * (slopes[j - 1] + exponent);
    const double target = std::pow(1 - y, power), form = std::exp2((power + offset) * exponent);
    for (int j = 1; j <= factors; ++j) {
      const double g = lobe.factor * std::min(1.0, 2 * (1 - y)) * j / factors;
      largest = std::max(largest, std::abs(shown_value(scale, g * form) - shown_value(scale, g * target)));
    }
  }
  return largest;
}

WeightedPower of_power(double power, double factor) {
  return {{power, power}, factor};
}

std::string text_of(const WeightedPower& lobe, double offset) {
  return std::to_string(lobe.power.most) + " " + std::to_string(lobe.factor) + " " + std::to_string(offset);
}

TEST(LobeError, OfAGaussianIsTheLargestThatIsShown) {
  const std::vector<double> slope{natural_slope};
  const LobeCells cells(slope, 1e5);
  for (const double power : {0.25, 1.0, 2.5, 16.0, 300.0, 1e5}) {
    for (const double reflectance : {0.01, 0.3, 1.0}) {
      const double factor = reflectance * (power + 2) / 8;
      for (const double offset : {0.0, 0.775}) {
        for (const ShownScale scale : {ShownScale::linear, ShownScale::codes}) {
          const WeightedPower lobe = of_power(power, factor);
          const double truth = brute_error(lobe, slope, offset, scale);
          const double proven = cells.largest_error(lobe, offset, scale, 0);
          EXPECT_GE(proven, truth) << text_of(lobe, offset);
          // cells are 2 % wide in t, at t up to 3 that is 6 %, in codes near black twice that; a hundred
          // factors miss the worst by a percent
          EXPECT_LE(proven, 1.15 * truth) << text_of(lobe, offset);
          EXPECT_EQ(cells.largest_error(lobe, offset, scale, 2 * proven), 2 * proven) << "enough is enough";
          for (const double share : {0.5, 0.9, 0.999})
            EXPECT_EQ(cells.largest_error(lobe, offset, scale, share * proven), proven)
                << text_of(lobe, offset) << ": what is left out for " << share << " of it cannot matter";
        }
      }
    }
  }
}

TEST(LobeError, OfSlopesIsTheLargestThatIsShown) {
  const std::vector<std::vector<double>> forms{{1.4418, -1.00729}, {1.44304, -0.592018, 1.24132}};
  for (const auto& slopes : forms) {
    const LobeCells cells(slopes, 1e5);
    for (const WeightedPower& lobe :
         {of_power(0.5, 0.3), of_power(4, 0.75), of_power(64, 8), of_power(3000, 400)}) {
      const double truth = brute_error(lobe, slopes, 0, ShownScale::linear);
      const double proven = cells.largest_error(lobe, 0, ShownScale::linear, 0);
      EXPECT_GE(proven, truth) << text_of(lobe, 0);
      // where slopes and logarithm nearly agree, a cell holds a change of sign
      EXPECT_LE(proven, 1.25 * truth) << text_of(lobe, 0);
    }
  }
}

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
        // Lawson's iteration comes within some percent of the minimax
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

TEST(ShownScale, ThereAndBack) {
  for (const double v : {0.0, 0.001, 0.0031308, 0.2, 1.0}) {
    for (const ShownScale scale : {ShownScale::linear, ShownScale::codes})
      EXPECT_NEAR(from_scale(scale, on_scale(scale, v)), v, 1e-6);
  }
  EXPECT_EQ(on_scale(ShownScale::linear, 3), 1);
  EXPECT_DOUBLE_EQ(on_scale(ShownScale::codes, 3), 255);
  EXPECT_EQ(from_scale(ShownScale::codes, 1000), 1);
}

// Of all values up to 1, neighbours near 1 are farthest apart, except at the kink of the encoding.
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
        const double one = cells.largest_error(of_power(power, factor), offset, ShownScale::linear, 0);
        EXPECT_GE(all, one) << power;
        // 3 % of n move t by as much, on both sides
        EXPECT_LE(all, 1.25 * one + 0.004) << power;
      }
    }
  }
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

/// A light of what floats or halves make of a lobe, all of it in that format: A c - A or slopes, the constant
/// reflectance and normalisation, n.l.
template <class T>
double measured_rounding(const LobeForm& form, double power, double reflectance) {
  const auto rounded = [](double x) { return static_cast<T>(x); };
  LobeConstants<T> constants;
  LobeConstants<double> exact;
  for (const double slope : form.slopes) {
    constants.slopes.push_back(rounded((power + form.offset) * slope));
    exact.slopes.push_back((power + form.offset) * slope);
  }
  const double normalisation = (power + 2) / 8;
  double largest = 0;
  for (int i = 0; i < 20000; ++i) {
    const T c = rounded(1 - i * 0.001 / power);
    if (!(static_cast<double>(c) >= 0)) break;
    for (const double light : {1.0, 0.71, 0.37}) {
      const T lobe = planned_lobe(form, c, constants);
      const auto shown = static_cast<double>(
          shown_specular(rounded(reflectance), rounded(normalisation), lobe, rounded(light)));
      const double truth = shown_specular(reflectance, normalisation,
                                          planned_lobe(form, static_cast<double>(c), exact), light);
      largest = std::max(largest, std::abs(shown - truth));
    }
  }
  return largest;
}

Lobes lobes_of_power(double power, double reflectance) {
  return {
      .all = {of_power(power, reflectance * (power + 2) / 8)}, .used = {}, .textures = {PowerTexture::none}};
}

TEST(RoundingError, IsNotExceeded) {
  for (const bool is_fused : {false, true}) {
    for (const double power : {8.0, 77.7, 300.5, 1e4}) {
      for (const double reflectance : {0.04, 0.3, 1.0}) {
        const LobeForm form{
            .kind = LobeKind::exponential, .offset = 0.7, .slopes = {natural_slope}, .is_fused = is_fused};
        const Lobes lobes = lobes_of_power(power, reflectance);
        const auto bound = [&](PixelPrecision precision) {
          return rounding_error({form, lobes, false, false}, precision, ShownScale::linear);
        };
        const std::string where = std::to_string(power) + " " + std::to_string(reflectance);
        const double in_float = measured_rounding<float>(form, power, reflectance);
        EXPECT_LE(in_float, bound(PixelPrecision::float32)) << where;
        EXPECT_LE(measured_rounding<Eigen::half>(form, power, reflectance), bound(PixelPrecision::float16))
            << where;
        EXPECT_GE(in_float, 0.04 * bound(PixelPrecision::float32)) << where << ": and is no idle bound";
      }
    }
  }
}

TEST(RoundingError, CountsWhatThereIs) {
  const LobeForm gaussian{.kind = LobeKind::exponential, .slopes = {natural_slope}};
  const Lobes lobes = lobes_of_power(20, 0.04);
  const auto in_float = [&](const RoundedShading& shading) {
    return rounding_error(shading, PixelPrecision::float32, ShownScale::linear);
  };
  const double plain = in_float({gaussian, lobes, false, false});
  EXPECT_GT(in_float({gaussian, lobes, true, false}), plain);
  Lobes textured = lobes;
  textured.textures = {PowerTexture::roughness};
  const double of_roughness = in_float({gaussian, textured, false, false});
  EXPECT_GT(of_roughness, plain);
  EXPECT_GT(in_float({gaussian, textured, false, true}), of_roughness);
  // slopes that cancel, 1.58 - 0.34 y: by 1.55 at y = 1
  const LobeForm cancelling{.kind = LobeKind::exponential, .slopes = {1.58, 0.34}};
  const LobeForm alike{.kind = LobeKind::exponential, .slopes = {1.58, -0.34}};
  EXPECT_GT(in_float({cancelling, lobes, false, false}), in_float({alike, lobes, false, false}));
  EXPECT_GT(rounding_error({gaussian, lobes, false, false}, PixelPrecision::float32, ShownScale::codes),
            100 * plain);
  // no half is 1e5
  EXPECT_EQ(rounding_error({gaussian, lobes_of_power(1e5, 0.04), false, false}, PixelPrecision::float16,
                           ShownScale::linear),
            1);
  EXPECT_EQ(name(PixelPrecision::float16), "half");
}

// The dot product itself: vectors of floats, with the products and sums of floats, around the edge of what is
// shown in white. The exact formula is moved so far whatever the form.
TEST(DotProductError, IsNotExceeded) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  const auto direction = [&] {
    std::array<double, 3> v{normal(random), normal(random), normal(random)};
    const double length = std::hypot(v[0], v[1], v[2]);
    for (double& x : v) x /= length;
    return v;
  };
  for (const double power : {0.5, 3.0, 77.7, 1e4, 263279.0}) {
    const double factor = (power + 2) / 8, c = std::min(1.0, std::pow(factor, -1 / power));
    const Lobes lobes{.all = {of_power(power, factor)}, .used = {}, .textures = {PowerTexture::none}};
    const double bound = dot_product_error(lobes, PixelPrecision::float32, ShownScale::linear);
    const double bound_of_codes = dot_product_error(lobes, PixelPrecision::float32, ShownScale::codes);
    double largest = 0, largest_code = 0;
    for (int i = 0; i < 20000; ++i) {
      const auto n = direction(), other = direction();
      // h is off n by an angle whose cosine is near c
      const double along = std::inner_product(n.begin(), n.end(), other.begin(), 0.0);
      const double near = c + (1 - c) * (i % 100 - 50) / 100.0,
                   across = std::sqrt((1 - near * near) / (1 - along * along));
      double exact = 0;
      float dot = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto a = static_cast<float>(n[k]),
                   b = static_cast<float>(near * n[k] + across * (other[k] - along * n[k]));
        exact += static_cast<double>(a) * static_cast<double>(b);
        dot += a * b;
      }
      const auto shown = [&](ShownScale scale, double cosine) {
        return shown_value(scale, factor * std::pow(std::clamp(cosine, 0.0, 1.0), power));
      };
      const auto rounded = static_cast<double>(dot);
      for (auto [scale, most] : {std::pair{ShownScale::linear, &largest}, {ShownScale::codes, &largest_code}})
        *most = std::max(*most, std::abs(shown(scale, rounded) - shown(scale, exact)));
    }
    EXPECT_LE(largest, bound) << power;
    EXPECT_GE(largest, 0.05 * bound) << power << ": and it is no idle bound";
    EXPECT_LE(largest_code, bound_of_codes) << power;
  }
  // of the roughness at which three.js stops
  const Lobes smooth{.all = {of_power(263279, 263281 / 8.0)}, .used = {}, .textures = {PowerTexture::none}};
  EXPECT_NEAR(dot_product_error(smooth, PixelPrecision::float32, ShownScale::linear), 0.046, 0.001);
  EXPECT_NEAR(dot_product_rounding(PixelPrecision::float16), 3 * 0x1p-11, 1e-5);
}

}  // namespace
}  // namespace shadefit::scene
