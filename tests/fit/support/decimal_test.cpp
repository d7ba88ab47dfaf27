#include "fit/support/decimal.hpp"

#include <gtest/gtest.h>

#include <array>

namespace shadefit {
namespace {

TEST(Decimal, ReadsFiniteDecimals) {
  EXPECT_EQ(parse_number("0.1"), 0.1);
  EXPECT_EQ(parse_number("-3e-2"), -0.03);
  for (const char* text : {"", "x", "1x", " 1", "nan", "NaN", "inf", "-inf", "1e400", "0x10", "1,5"}) {
    EXPECT_FALSE(parse_number(text).has_value()) << text;
  }
}

TEST(Decimal, TheShortestTextReadsBack) {
  for (const char* text : {"0.1", "-0.03", "5e-324", "1.7976931348623157e+308", "0.775", "1"}) {
    EXPECT_EQ(to_text(*parse_number(text)), text);
  }
}

TEST(Decimal, SaysAsManyDigitsAsAreMeant) {
  EXPECT_EQ(decimal(0.775, 10), "0.775");
  EXPECT_EQ(decimal(-0.0, 3), "0");
  EXPECT_EQ(decimal(1.25e-7, 2), "1.2e-07");
  EXPECT_EQ(decimal(2048, 6), "2048");
  EXPECT_EQ(counted(1, "step"), "1 step");
  EXPECT_EQ(counted(2, "step"), "2 steps");
  EXPECT_EQ(enumerated(std::array{"a", "b", "c"}), "a, b and c");
  EXPECT_EQ(enumerated(std::array{"a"}), "a");
}

}  // namespace
}  // namespace shadefit
