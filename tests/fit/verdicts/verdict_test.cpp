#include "fit/verdicts/verdict.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace shadefit {
namespace {

TEST(UnitsOff, CountsInTheLastPrintedDigit) {
  EXPECT_EQ(units_off("0.788", 0.78754), 0);
  EXPECT_EQ(units_off("0.788", 0.7874999), 1);
  EXPECT_EQ(units_off("0.3", 0.25), 0) << "a half, exact in binary, rounds away from zero";
  EXPECT_EQ(units_off("0.788", 0.78849999), 0);
  EXPECT_EQ(units_off("-5.55473", -5.5547278), 0);
  EXPECT_EQ(units_off("-0.3", -0.25), 0) << "away from zero on the negative side too";
  EXPECT_EQ(units_off("0.775", 0.785), 10);
  EXPECT_EQ(units_off("4", 4.49), 0);
  EXPECT_EQ(units_off("4", 3.5), 0);
  EXPECT_EQ(units_off("4", 4.5), 1);
  EXPECT_EQ(units_off("8.656170", 8.6561702453), 0) << "a trailing zero is a digit";
  EXPECT_EQ(units_off("8.656170", 8.6561706), 1);
  EXPECT_GT(units_off("1", 1e300), 1000000);
  EXPECT_GT(units_off("1", std::nan("")), 1000000);
}

TEST(LastUnit, OfThePrintedDigits) {
  EXPECT_EQ(last_unit("0.788"), 0.001);
  EXPECT_EQ(last_unit("4"), 1);
  EXPECT_EQ(last_unit("8.656170"), 1e-6);
}

TEST(Judge, TakesItsOwnObjectiveFirstThenTheOthersInOrder) {
  const std::vector<Alternative> others{{"angle", 0.6732}, {"convention", 1.0}};
  const auto verdict = [&](std::string_view printed) { return judge(printed, {"cosine", 0.78754}, others); };
  EXPECT_EQ(verdict("0.788").verdict, Verdict::confirmed);
  EXPECT_EQ(verdict("0.788").objective, "cosine");
  EXPECT_EQ(verdict("0.787").verdict, Verdict::rounding) << "truncated";
  EXPECT_EQ(verdict("0.789").verdict, Verdict::rounding);
  EXPECT_EQ(verdict("0.786").verdict, Verdict::refuted);
  EXPECT_EQ(verdict("0.786").objective, "");
  EXPECT_EQ(verdict("0.673").verdict, Verdict::other_objective);
  EXPECT_EQ(verdict("0.673").objective, "angle");
  EXPECT_EQ(verdict("0.673").value, 0.6732) << "the value that has the digits";
  EXPECT_EQ(verdict("0.787").value, 0.78754);
  EXPECT_EQ(verdict("1.000").objective, "convention");
  EXPECT_EQ(verdict("0.672").verdict, Verdict::refuted) << "another objective has to give all printed digits";
}

TEST(Verdict, HasNames) {
  EXPECT_EQ(name(Verdict::confirmed), "confirmed");
  EXPECT_EQ(name(Verdict::rounding), "rounding");
  EXPECT_EQ(name(Verdict::other_objective), "other-objective");
  EXPECT_EQ(name(Verdict::conditional), "conditional");
  EXPECT_EQ(name(Verdict::refuted), "refuted");
}

}  // namespace
}  // namespace shadefit
