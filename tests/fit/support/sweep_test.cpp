#include "fit/support/sweep.hpp"
#include "fit/support/decimal.hpp"
#include "tests/refusal.hpp"

#include <gtest/gtest.h>

namespace shadefit {
namespace {

using Numbers = std::vector<double>;

TEST(Sweep, NumbersAndRanges) {
  EXPECT_EQ(parse_sweep("5"), Numbers{5});
  EXPECT_EQ(parse_sweep("2.5e5"), Numbers{2.5e5});
  EXPECT_EQ(parse_sweep("1:4:1"), (Numbers{1, 2, 3, 4}));
  EXPECT_EQ(parse_sweep("1:3:1,25,1000"), (Numbers{1, 2, 3, 25, 1000}));
  EXPECT_EQ(parse_sweep("7:7:1"), Numbers{7});
}

TEST(Sweep, IncludesItsEndWithinHalfAStep) {
  EXPECT_EQ(parse_sweep("1:2:0.4"), (Numbers{1, 1.4, 1.8, 2})) << "2.2 is half a step beyond, and ends at 2";
  EXPECT_EQ(parse_sweep("1:1.9:0.4").size(), 3U) << "2.2 is three quarters of a step away, and out";
  EXPECT_EQ(parse_sweep("0.1:1:0.1"), (Numbers{0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1}))
      << "as decimals mean them";
  EXPECT_EQ(parse_sweep("1e308:1.7e308:1e308"), (Numbers{1e308, 1.7e308}));
}

void expect_refusal(const char* text, const char* message) {
  EXPECT_EQ(testing::refusal([&] { parse_sweep(text); }), message);
}

TEST(Sweep, RefusalsNameThePartAndTheRule) {
  expect_refusal("0", "'0' is not greater than 0");
  expect_refusal("-1", "'-1' is not greater than 0");
  expect_refusal("", "'' is not a finite number");
  expect_refusal("1,,2", "'' is not a finite number");
  expect_refusal("1e400", "'1e400' is beyond the range of a double");
  expect_refusal("1:2", "'1:2' is not a range A:B:STEP");
  expect_refusal("1:2:3:4", "'1:2:3:4' is not a range A:B:STEP");
  expect_refusal("5:1:1", "'5:1:1' is a range that ends before it begins");
  expect_refusal("1e-400", "'1e-400' is beyond the range of a double");
  expect_refusal("1:5:0", "'0' in '1:5:0' is not greater than 0");
  expect_refusal("1:5:-1", "'-1' in '1:5:-1' is not greater than 0");
  expect_refusal("1:x:1", "'x' in '1:x:1' is not a finite number");
  expect_refusal("1:1e9:1", "'1:1e9:1' is a range of more than 100000 numbers");
  expect_refusal("1:90000:1,1:90000:1", "'1:90000:1,1:90000:1' holds more than 100000 numbers");
  expect_refusal("1:1e300:1e-300", "'1:1e300:1e-300' is a range of more than 100000 numbers");
}

}  // namespace
}  // namespace shadefit
