#include "fit/errors/banding.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace shadefit {
namespace {

double ramp(double c) {
  return c;
}

/// The linear values of whole 8-bit sRGB codes, `apart` codes from one to the next.
double staircase(double c, double apart) {
  const double code =
      std::floor(srgb_code(c) / apart + 1e-9) * apart;  // the code of 1 is 255 but for its rounding
  const double encoded = code / 255;
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

std::vector<double> unit_interval(int count) {
  std::vector<double> places;
  for (int i = 0; i <= count; ++i) places.push_back(static_cast<double>(i) / count);
  return places;
}

TEST(Banding, AStaircaseOfSoManyCodesStepsByThem) {
  for (const double apart : {1.0, 5.0, 17.0}) {
    const auto stairs = [&](double c) { return staircase(c, apart); };
    for (const int samples : {64, 1024}) {
      const Banding found = banding(unit_interval(samples), stairs, ramp);
      // What the exact curve still does where a jump is narrowed down to is 0.01 of a code.
      EXPECT_NEAR(found.step, apart, 0.011) << samples;
    }
    EXPECT_EQ(banding(unit_interval(4096), stairs, ramp).codes, 1 + static_cast<int>(255 / apart));
  }
}

TEST(Banding, TheExactCurveHasNone) {
  const Banding found = banding(unit_interval(64), ramp, ramp);
  EXPECT_EQ(found.step, 0);
  // where samples stand for intervals, its step from one to the next is a jump
  EXPECT_GT(banding(unit_interval(64), ramp, [](double) { return 1.0; }).step, 1);
  EXPECT_EQ(banding(unit_interval(8192), ramp, ramp).codes, 256);
}

TEST(Banding, SmallJumpsMayBeLeftAside) {
  const auto stairs = [](double c) { return staircase(c, 5); };
  EXPECT_NEAR(banding(unit_interval(64), stairs, ramp, 2).step, 5, 0.011);
  EXPECT_EQ(banding(unit_interval(64), stairs, ramp, 20).step, 20);
}

TEST(Banding, SamplesAreHalvesAndFloats) {
  const auto halves = halves_near_the_peak();
  EXPECT_EQ(halves.size(), 1025u);
  EXPECT_EQ(halves.front(), 0.5);
  EXPECT_EQ(halves.back(), 1);
  for (const double k : {1.0, 8.0, 1000.0, 2048.0, 4096.0}) {
    const auto floats = floats_over_the_highlight(k, 2048);
    EXPECT_EQ(floats.back(), 1);
    for (const double c : floats) EXPECT_EQ(static_cast<double>(static_cast<float>(c)), c);
    EXPECT_TRUE(floats.front() == 0.5 || std::pow(floats.front(), k) < std::exp(-10)) << k;
    EXPECT_TRUE(std::is_sorted(floats.begin(), floats.end()));
  }
}

}  // namespace
}  // namespace shadefit
