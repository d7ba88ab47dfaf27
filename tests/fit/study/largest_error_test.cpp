#include "fit/study/largest_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "fit/study/study.hpp"

namespace shadefit {
namespace {

using Numbers = std::vector<double>;

StudyExtremum largest(const std::string& target, const std::string& form, const Numbers& parameters) {
  const ReadStudy study = read_study({.target = target, .form = form, .over = {{"x", "0", "1"}}});
  return largest_error(study, parameters);
}

// 1 - (1 - x)/n = x + (1 - x)/21 for n = 1.05. In double the two differ by an ulp at many places.
TEST(LargestErrorOfStudy, AnExactFormHasNone) {
  const StudyExtremum none = largest("x + (1 - x)/21", "1 - (1 - x)/n", {1.05});
  EXPECT_EQ(none.magnitude, 0);
  EXPECT_EQ(none.at, Numbers{0});
}

// The derivative of the error by n is (1 - x)/n^2: 0.907 at x = 0.
TEST(LargestErrorOfStudy, ADigitOfAFormIsNoRounding) {
  const double change = 1e-13;
  const StudyExtremum found = largest("x + (1 - x)/21", "1 - (1 - x)/n", {1.05 + change});
  EXPECT_NEAR(found.magnitude, change / (1.05 * 1.05), 4e-16) << "two ulps of 1, the size of the form";
  EXPECT_NEAR(found.at.front(), 0, 0.01);
}

// The error jumps to 1/4 at a place that has no double, and falls from there. In wider arithmetic the place
// next to the jump may be on its other side, without an error.
TEST(LargestErrorOfStudy, AJumpIsNoRounding) {
  for (const std::string at : {"0.1/3", "0.2/3", "0.4/3", "0.5/3", "0.7/3", "1.1/3", "1.3/3", "1.7/3"}) {
    const StudyExtremum found =
        largest("x", "x + a (x < " + at + " ? 0 : exp(-200 (x - " + at + ")))", {0.25});
    EXPECT_NEAR(found.magnitude, 0.25, 1e-10) << at;
  }
}

// At x = 0 the error of sqrt(1 - x) (a + b x) is pi/2 - a, at 5.6e-17 it has the same digits.
TEST(LargestErrorOfStudy, AnEndIsSaidToBeTheEnd) {
  const StudyExtremum found =
      largest("acos(x)", "sqrt(1 - x) (a + b x)", {1.565154636014611, -0.163889932843928});
  EXPECT_EQ(found.at, Numbers{0});
  EXPECT_NEAR(found.magnitude, 1.5707963267948966 - 1.565154636014611, 4e-16);
}

// Places count up to the edges, where log(x) has no value and x log(x) is NaN.
TEST(LargestErrorOfStudy, APlaceWithoutAValueDoesNotCount) {
  const StudyExtremum found = largest("x log(x)", "a x", {0});
  EXPECT_NEAR(found.magnitude, 1 / 2.718281828459045, 4e-16);
  EXPECT_NEAR(found.at.front(), 1 / 2.718281828459045, 1e-7) << "the top is flat: half of the digits";
  EXPECT_EQ(largest("log(x)", "a x", {1}).magnitude, HUGE_VAL);
}

}  // namespace
}  // namespace shadefit
