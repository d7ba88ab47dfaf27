#include "scene/plan/shown_scale.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "approx/encoding.hpp"

namespace shadefit::scene {
namespace {

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

}  // namespace
}  // namespace shadefit::scene
