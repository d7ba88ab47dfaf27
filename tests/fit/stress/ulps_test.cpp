#include "fit/errors/ulps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace shadefit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Ulps, AreThoseOfTheBinadeOfTheTruth) {
  const double least = std::numeric_limits<double>::denorm_min(), normal = std::numeric_limits<double>::min();
  struct Case {
    double computed, truth, ulps;
    const char* why = "";
    BinaryFormat format = double_format;
  };
  for (const auto& [computed, truth, ulps, why, format] :
       {Case{1, 1, 0},
        {-0.0, 0.0, 0, "zero has no sign"},
        {0.0, -0.0, 0, "zero has no sign"},
        {std::nextafter(1.0, 2), 1, 1},
        {std::nextafter(1.0, 0), 1, 0.5, "below a power of two the steps halve"},
        {1, std::nextafter(1.0, 0), 1, "the unit is that of the truth"},
        {1, 2, 0x1p51},
        {2, 1, 0x1p52},
        {1 + 0x1p-10, 1, 1, "", half_format},
        {1 - 0x1p-11, 1, 0.5, "", half_format},
        {1 + 0x1p-23, 1, 1, "", float_format},
        {0.5, 0.75, 512, "", half_format},
        {least, 0, 1},
        {0, least, 1},
        {-least, least, 2, "across zero"},
        {normal, normal - least, 1, "across the end of the normal numbers"},
        {normal - least, normal, 1, "where the spacing stays"},
        {0, 0x1p-24, 1, "", half_format},
        {0, 0x1p-25, 0.5, "", half_format},
        {0x1p-149, 0, 1, "", float_format},
        {-1, 1, 0x1p53, "across zero"},
        {-0x1p-24, 1, 0x1p23 + 0.5, "across zero", float_format},
        {std::nan(""), 1, infinity},
        {infinity, 1, infinity},
        {-infinity, -1, infinity},
        // Rounding to nearest goes to infinity from 65520 on, half an ulp beyond 65504.
        {infinity, 65520, 0, "", half_format},
        {infinity, 65519, infinity, "", half_format},
        {65504, 65519, 15 / 32.0, "", half_format},
        {65504, 65536, 1, "beyond the last binade its spacing goes on", half_format},
        {-infinity, 65536, infinity, "the wrong infinity", half_format},
        {-infinity, -65536, 0, "", half_format}})
    EXPECT_EQ(ulps_off(computed, Decimal50(truth), format), ulps)
        << computed << " for " << truth << ": " << why;
}

TEST(Ulps, OfTruthsThatNoDoubleIs) {
  EXPECT_EQ(ulps_off(1, Decimal50(1) + Decimal50(0x1p-54), double_format), 0.25);
  EXPECT_EQ(ulps_off(1, Decimal50(1) - Decimal50(0x1p-54), double_format), 0.5);
  EXPECT_EQ(ulps_off(0, ldexp(Decimal50(1), -1080), double_format), 0x1p-6) << "beyond a double's range";
  const Decimal50 endless = std::numeric_limits<Decimal50>::infinity();
  EXPECT_EQ(ulps_off(infinity, endless, double_format), 0);
  EXPECT_EQ(ulps_off(1, endless, double_format), infinity);
  EXPECT_FALSE(overflows(Decimal50(std::numeric_limits<double>::max()), double_format));
  EXPECT_TRUE(overflows(ldexp(Decimal50(1), 1024), double_format));
  EXPECT_THROW(ulps_off(1, std::numeric_limits<Decimal50>::quiet_NaN(), double_format),
               std::invalid_argument);
}

}  // namespace
}  // namespace shadefit
