#include "fit/errors/ulps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace shadefit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double off(double computed, double truth, const BinaryFormat& format = double_format) {
  return ulps_off(computed, Decimal50(truth), format);
}

TEST(Ulps, OfEqualNumbersAreNone) {
  EXPECT_EQ(off(1, 1), 0);
  EXPECT_EQ(off(-0.0, 0.0), 0) << "zero has no sign";
  EXPECT_EQ(off(0.0, -0.0), 0);
}

TEST(Ulps, AtAPowerOfTwoAreThoseOfTheBinadeAbove) {
  EXPECT_EQ(off(std::nextafter(1.0, 2), 1), 1);
  EXPECT_EQ(off(std::nextafter(1.0, 0), 1), 0.5) << "below a power of two the steps halve";
  EXPECT_EQ(off(1, std::nextafter(1.0, 0)), 1) << "the unit is that of the truth";
  EXPECT_EQ(off(1, 2), 0x1p51);
  EXPECT_EQ(off(2, 1), 0x1p52);
  EXPECT_EQ(off(1 + 0x1p-10, 1, half_format), 1);
  EXPECT_EQ(off(1 - 0x1p-11, 1, half_format), 0.5);
  EXPECT_EQ(off(1 + 0x1p-23, 1, float_format), 1);
}

TEST(Ulps, MeasureFractions) {
  EXPECT_EQ(ulps_off(1, Decimal50(1) + Decimal50(0x1p-54), double_format), 0.25);
  EXPECT_EQ(ulps_off(1, Decimal50(1) - Decimal50(0x1p-54), double_format), 0.5);
  EXPECT_EQ(off(0.5, 0.75, half_format), 512);
}

TEST(Ulps, OfSubnormalsAreTheLeastOfThem) {
  const double least = std::numeric_limits<double>::denorm_min(), normal = std::numeric_limits<double>::min();
  EXPECT_EQ(off(least, 0), 1);
  EXPECT_EQ(off(0, least), 1);
  EXPECT_EQ(off(-least, least), 2) << "across zero";
  EXPECT_EQ(off(normal, normal - least), 1) << "across the end of the normal numbers";
  EXPECT_EQ(off(normal - least, normal), 1) << "where the spacing stays";
  EXPECT_EQ(off(0, 0x1p-24, half_format), 1);
  EXPECT_EQ(off(0, 0x1p-25, half_format), 0.5);
  EXPECT_EQ(off(0x1p-149, 0, float_format), 1);
  EXPECT_EQ(ulps_off(0, ldexp(Decimal50(1), -1080), double_format), 0x1p-6) << "beyond a double's range";
}

TEST(Ulps, AcrossZeroAreADistanceLikeAnyOther) {
  EXPECT_EQ(off(-1, 1), 0x1p53);
  EXPECT_EQ(off(-0x1p-24, 1, float_format), 0x1p23 + 0.5);
}

TEST(Ulps, OfWhatIsNoNumberAreInfinite) {
  EXPECT_EQ(off(std::nan(""), 1), infinity);
  EXPECT_EQ(off(infinity, 1), infinity);
  EXPECT_EQ(off(-infinity, -1), infinity);
}

TEST(Ulps, WhereTheTruthOverflows) {
  // Rounding to nearest goes to infinity from 65520 on, half an ulp beyond 65504.
  EXPECT_EQ(off(infinity, 65520, half_format), 0);
  EXPECT_EQ(off(infinity, 65519, half_format), infinity);
  EXPECT_EQ(off(65504, 65519, half_format), 15 / 32.0);
  EXPECT_EQ(off(65504, 65536, half_format), 1) << "beyond the last binade its spacing goes on";
  EXPECT_EQ(off(-infinity, 65536, half_format), infinity) << "the wrong infinity";
  EXPECT_EQ(off(-infinity, -65536, half_format), 0);
  const Decimal50 endless = std::numeric_limits<Decimal50>::infinity();
  EXPECT_EQ(ulps_off(infinity, endless, double_format), 0);
  EXPECT_EQ(ulps_off(1, endless, double_format), infinity);
  EXPECT_FALSE(overflows(Decimal50(std::numeric_limits<double>::max()), double_format));
  EXPECT_TRUE(overflows(ldexp(Decimal50(1), 1024), double_format));
}

TEST(Ulps, NeedATruth) {
  EXPECT_THROW(ulps_off(1, std::numeric_limits<Decimal50>::quiet_NaN(), double_format),
               std::invalid_argument);
}

}  // namespace
}  // namespace shadefit
