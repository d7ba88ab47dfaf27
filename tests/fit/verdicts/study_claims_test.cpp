#include "fit/verdicts/study_claims.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>

#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

TEST(StudyClaims, JudgesStatedErrors) {
  const Study line{.target = "x + 1", .form = "a x + b", .over = {{"x", "0", "1"}}};
  const auto verdict = [&](StatedError error, const char* text) {
    const JudgedError judged = judge_error({error, text}, line, {1.0, 1.5});
    return fmt::format("{:.12g} {}", judged.computed, name(judged.verdict));
  };
  // The error is 1/2 everywhere; the largest relative one is 1/2 at x = 0.
  EXPECT_EQ(verdict(StatedError::max_abs_error, "0.5"), "0.5 confirmed");
  EXPECT_EQ(verdict(StatedError::max_abs_error, "0.6"), "0.5 confirmed");
  EXPECT_EQ(verdict(StatedError::max_abs_error, "0.4"), "0.5 rounding");
  EXPECT_EQ(verdict(StatedError::max_abs_error, "0.3"), "0.5 refuted");
  EXPECT_EQ(verdict(StatedError::max_rel_error, "0.5"), "0.5 confirmed");
  EXPECT_EQ(verdict(StatedError::rms_error, "0.50"), "0.5 confirmed");
  EXPECT_EQ(verdict(StatedError::mean_square_error, "0.25"), "0.25 confirmed");
  EXPECT_EQ(verdict(StatedError::mean_square_error, "0.10"), "0.25 refuted");
  // x + 1 by 2.5 x + 1.5: the largest absolute error is 2, at 1; the largest relative one is 1, there too.
  const JudgedError relative = judge_error({StatedError::max_rel_error, "1.0"}, line, {2.5, 1.5});
  EXPECT_NEAR(relative.computed, 1, 1e-12);
  EXPECT_EQ(name(relative.verdict), "confirmed");
  const Study zero{.target = "x", .form = "a x + b", .over = {{"x", "0", "1"}}};
  const JudgedError none = judge_error({StatedError::max_rel_error, "0.1"}, zero, {1.0, 0.5});
  EXPECT_FALSE(std::isfinite(none.computed));
  EXPECT_EQ(name(none.verdict), "refuted");
}

// x^2 by x: the error x - x^2 has the mean 1/6 and the largest value 1/4; the relative error is 1/x - 1.
TEST(StudyClaims, JudgesMeansAndRanges) {
  const Study parabola{.target = "x^2", .form = "a x", .over = {{"x", "0", "1"}}};
  const auto computed = [&](const ErrorClaim& claim, double a) {
    return judge_error(claim, parabola, {a}).computed;
  };
  EXPECT_NEAR(computed({StatedError::mean_abs_error, "0.1"}, 1), 1.0 / 6, 1e-14);
  // |x/2 - x^2| is x/2 - x^2 up to 1/2: 1/48 + 1/48 + 1/12.
  EXPECT_NEAR(computed({StatedError::mean_abs_error, "0.1"}, 0.5), 1.0 / 48 + 5.0 / 48, 1e-14);
  const std::vector<StudyRange> upper{{"x", "1/2", "1"}}, beyond{{"x", "1", "3"}};
  EXPECT_NEAR(computed({StatedError::mean_rel_error, "0.1", {}, upper}, 1), 2 * std::log(2.0) - 1, 1e-13);
  EXPECT_NEAR(computed({StatedError::max_abs_error, "0.1", {}, beyond}, 1), 6, 1e-12);
  EXPECT_NEAR(computed({StatedError::rms_error, "0.1", {}, upper}, 0), std::sqrt(2 * 31.0 / 160), 1e-12);
  EXPECT_EQ(name(judge_error({StatedError::max_rel_error, "1.0", {}, upper}, parabola, {1}).verdict),
            "confirmed");
  EXPECT_FALSE(std::isfinite(computed({StatedError::mean_rel_error, "0.1"}, 1)));
}

TEST(StudyClaims, OfATableTakesTheRowsInTheRange) {
  Study table{.target = {}, .form = "a x", .over = {{"x", "", ""}}};
  table.rows = std::make_shared<const MeasuredRows>(MeasuredRows{.file = OthersText("rows.csv"),
                                                                 .places = {{0.1, 0.5, 0.7, 1}},
                                                                 .value = {9, 0.4, 0.9, 5},
                                                                 .sigma = {}});
  const ErrorClaim claim{StatedError::mean_abs_error, "0.15", {}, {{"x", "0.5", "0.7"}}};
  const JudgedError judged = judge_error(claim, table, {1});
  EXPECT_NEAR(judged.computed, 0.15, 1e-15);
  EXPECT_EQ(name(judged.verdict), "confirmed");
  const ErrorClaim outside{StatedError::mean_abs_error, "0.15", {}, {{"x", "2", "3"}}};
  try {
    judge_error(outside, table, {1});
    ADD_FAILURE();
  } catch (const UserError& error) {
    EXPECT_STREQ(error.what(), "the table 'rows.csv' has no rows in the range of the claim 0.15");
  }
}

}  // namespace
}  // namespace shadefit
