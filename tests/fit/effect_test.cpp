#include "fit/effect.hpp"

#include <gtest/gtest.h>

#include "fit/fit.hpp"

namespace shadefit {
namespace {

TEST(HalfUlp, AtPowersOfTwoAndInTheSubnormals) {
  EXPECT_EQ(half_ulp(1), 0x1p-10);
  EXPECT_EQ(half_ulp(1.999), 0x1p-10);
  EXPECT_EQ(half_ulp(0.999), 0x1p-11);
  EXPECT_EQ(half_ulp(-1), 0x1p-10);
  EXPECT_EQ(half_ulp(0x1p-14), 0x1p-24);
  EXPECT_EQ(half_ulp(0x1p-15), 0x1p-24);
  EXPECT_EQ(half_ulp(0), 0x1p-24);
}

Effect effect(std::vector<double> from, std::vector<double> to) {
  return find_family("fresnel-quadratic")->effect(0, {}, from, to);
}

// The two mistyped copies in circulation, as measured on a dense grid: 3.7e-6 and 6.5e-7.
TEST(Effect, OfTheMistypedCopies) {
  const auto first = effect({-5.55473, -6.98316}, {-5.55437, -6.98316});
  EXPECT_NEAR(first.absolute.magnitude, 3.73e-6, 1e-8);
  EXPECT_LT(first.srgb_codes, 0.002);
  EXPECT_LT(first.half_ulps, 0.5);
  const auto second = effect({-5.55473, -6.98316}, {-5.55473, -6.983146});
  EXPECT_NEAR(second.absolute.magnitude, 6.49e-7, 1e-9);
}

TEST(Effect, NoneAndLarge) {
  EXPECT_EQ(effect({-5, -7}, {-5, -7}).absolute.magnitude, 0);
  EXPECT_EQ(effect({-5, -7}, {-5, -7}).srgb_codes, 0);
  // exp2(0) = 1 everywhere: the change is 1 - f, largest at c = 1, all 255 codes but the last
  const auto large = effect({-5, -7}, {0, 0});
  EXPECT_NEAR(large.absolute.magnitude, 1 - std::exp2(-12.0), 1e-15);
  EXPECT_EQ(large.absolute.at.cos_theta, 1);
  EXPECT_GT(large.srgb_codes, 254);
  EXPECT_GT(large.relative, 200) << "where the curve was one code";
}

}  // namespace
}  // namespace shadefit
