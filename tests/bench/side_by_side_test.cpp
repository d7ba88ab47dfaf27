#include <gtest/gtest.h>

#include "bench/peers/truth.hpp"
#include "bench/peers/verdict.hpp"

namespace shadefit::side_by_side {
namespace {

Row ours(double seconds, double digits) {
  return {.task = "T1",
          .tool = "shadefit",
          .variant = "from nothing",
          .is_ours = true,
          .seconds = seconds,
          .process_seconds = {},
          .digits = digits};
}

Row peer(double seconds, double digits) {
  return {.task = "T1",
          .tool = "peer",
          .variant = "any",
          .seconds = seconds,
          .process_seconds = {},
          .digits = digits};
}

TEST(SideBySide, DigitsAreThoseOfTheRelativeError) {
  EXPECT_NEAR(correct_digits("-5.5547", "-5.5547278126488394979946917335879756"), 5.30, 0.01);
  EXPECT_NEAR(correct_digits("2.0000000000000004", "2"), 15.70, 0.01);
  // Beyond double: Sollya's answers have more digits, which a double would lose.
  EXPECT_NEAR(correct_digits("1.000000000000000000000001", "1"), 24, 0.01);
  EXPECT_EQ(correct_digits("2", "2"), 40);
  EXPECT_EQ(correct_digits("5", "0.75"), 0);
  for (const char* none : {"nan", "inf", "-inf", "error", ""})
    EXPECT_EQ(correct_digits(none, "0.75"), 0) << none;
}

TEST(SideBySide, AnExponentHasOneName) {
  EXPECT_EQ(answer_name("x", "1e6"), answer_name("x", "1000000"));
  EXPECT_EQ(answer_name("x", "1e6"), answer_name("x", "1000000.0"));
  EXPECT_EQ(answer_name("a", ""), answer_name("a", "-"));
  EXPECT_NE(answer_name("x", "3"), answer_name("x", "4"));
}

// Sollya's supnorm at 200 bits gives the first digits of T5.
TEST(SideBySide, EveryTaskHasItsTruth) {
  const auto all = tasks(SHADEFIT_SOURCE_DIR "/tests/references");
  std::size_t sizes[] = {2, 13, 4, 11, 2, 2, 1, 32, 8};
  ASSERT_EQ(all.size(), std::size(sizes));
  for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(all[i].truth.size(), sizes[i]) << all[i].id;
  EXPECT_GT(correct_digits(all[6].truth.at("level -"), "3.7664127395073188128246967966686874574e-3"), 35);
}

TEST(SideBySide, TenTimesAsFastHolds) {
  EXPECT_TRUE(judge({ours(1e-6, 15), peer(1.001e-5, 14)}, "T1").holds);
  const TaskVerdict slow = judge({ours(1e-6, 15), peer(9.9e-6, 14)}, "T1");
  EXPECT_FALSE(slow.holds);
  EXPECT_TRUE(slow.is_slow);
  EXPECT_EQ(slow.text, "ONLY 9.9 x");
}

TEST(SideBySide, OnlyAPeerWithAsManyDigitsCounts) {
  const std::vector rows{ours(1e-6, 15), peer(2e-6, 13.9), peer(1.2e-4, 14), peer(3e-5, 15)};
  const TaskVerdict verdict = judge(rows, "T1");
  EXPECT_TRUE(verdict.holds);
  EXPECT_EQ(verdict.as_exact, &rows[3]);
  EXPECT_EQ(verdict.usual, &rows[1]);
  EXPECT_EQ(verdict.text, "30.0 x");
  const TaskVerdict alone = judge({ours(1e-6, 15), peer(2e-6, 13.9)}, "T1");
  EXPECT_TRUE(alone.holds);
  EXPECT_EQ(alone.as_exact, nullptr);
  EXPECT_EQ(alone.text, "no peer reaches our digits");
}

TEST(SideBySide, AnExpertsWayIsJudgedButNotUsual) {
  std::vector rows{ours(1e-6, 15), peer(2e-6, 15), peer(1.2e-4, 5)};
  rows[1].is_expert = true;
  const TaskVerdict verdict = judge(rows, "T1");
  EXPECT_FALSE(verdict.holds);
  EXPECT_EQ(verdict.as_exact, &rows[1]);
  EXPECT_EQ(verdict.usual, &rows[2]);
}

TEST(SideBySide, WhatIsListedFailedOrElsewhereDoesNotCount) {
  Row listed = peer(2e-6, 15), failed = peer(2e-6, 15), elsewhere = peer(2e-6, 15);
  listed.is_judged = false;
  failed.seconds.reset();
  elsewhere.task = "T2";
  const TaskVerdict verdict = judge({ours(1e-6, 15), listed, failed, elsewhere}, "T1");
  EXPECT_TRUE(verdict.holds);
  EXPECT_EQ(verdict.text, "no peer ran");
}

TEST(SideBySide, OursMayNeitherFailNorLoseDigits) {
  EXPECT_EQ(judge({ours(1e-6, 13.9), peer(1, 15)}, "T1").text, "OURS LOST DIGITS");
  EXPECT_FALSE(judge({ours(1e-6, 13.9), peer(1, 15)}, "T1").holds);
  EXPECT_EQ(judge({peer(1, 15)}, "T1").text, "OURS FAILED");
  EXPECT_FALSE(judge({peer(1, 15)}, "T1").holds);
}

}  // namespace
}  // namespace shadefit::side_by_side
