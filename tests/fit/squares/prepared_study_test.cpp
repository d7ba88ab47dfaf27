#include "fit/squares/prepared_study.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "fit/squares/solve_study.hpp"
#include "tests/refusal.hpp"

/// Fits of a study that is read once.
namespace shadefit {
namespace {

/// Every start in the basin gives the answer of the search, to the digits that both claim.
void expect_the_answer_of_the_search(const Study& study, const std::vector<std::vector<double>>& starts) {
  const StudyFit searched = solve_study(read_study(study), {});
  PreparedStudy prepared(study);
  EXPECT_EQ(prepared.parameters(), searched.names);
  for (const std::vector<double>& start : starts) {
    const StudyFit fit = prepared.fit(start);
    ASSERT_EQ(fit.status, Status::converged) << study.form << ": " << fit.why;
    EXPECT_GE(fit.digits, searched.digits - 1) << study.form;
    for (std::size_t i = 0; i < start.size(); ++i)
      EXPECT_NEAR(fit.parameters[i] / searched.parameters[i], 1, 1e-12)
          << study.form << ", from " << start[i];
    // Ten digits of an rms error are printed.
    EXPECT_NEAR(fit.rms_error / searched.rms_error, 1, 1e-10) << study.form;
  }
}

TEST(PreparedStudy, HasTheAnswerOfTheSearchFromEveryStart) {
  expect_the_answer_of_the_search(
      {.target = "(1-c)^5", .form = "exp2((a c + b) c)", .over = {{"c", "0", "1"}}},
      {{-5.55473, -6.98316}, {-5, -7}, {-8, -4}, {-5.55473, -6.98316}});
}

TEST(PreparedStudy, CutsThePanelsOfALobe) {
  expect_the_answer_of_the_search(
      {.target = "exp(-400 (1 - c))", .form = "c^(b/8)", .over = {{"c", "0", "1"}}}, {{3000}, {3300}});
}

// By mpmath: the normal equations of integrals in 30 digits that are split at the line.
TEST(PreparedStudy, SeesANarrowLine) {
  PreparedStudy prepared(
      {.target = "acos(x) + 0.1 exp(-((x - 0.3432)/0.003)^2)", .form = "a + b x", .over = {{"x", "0", "1"}}});
  const StudyFit fit = prepared.fit({1, -1});
  ASSERT_EQ(fit.status, Status::converged) << fit.why;
  EXPECT_NEAR(fit.parameters[0] / 1.64483750333780629880475154758, 1, 1e-13);
  EXPECT_NEAR(fit.parameters[1] / -1.28861153436506928799312419466, 1, 1e-13);
  EXPECT_NEAR(fit.rms_error / 0.0590575768447314234776654811635, 1, 1e-10);
}

// Of 1 + x^2 long double keeps eleven digits of x^2.
TEST(PreparedStudy, HasTheDigitsThatLongDoubleRoundsAway) {
  PreparedStudy prepared({.target = "1 + x^2", .form = "a + b x^2", .over = {{"x", "0", "1e-4"}}});
  const StudyFit fit = prepared.fit({2, 3});
  ASSERT_EQ(fit.status, Status::converged) << fit.why;
  EXPECT_EQ(fit.parameters, (std::vector<double>{1, 1}));
}

TEST(PreparedStudy, FollowsKinksThatItsParametersMove) {
  expect_the_answer_of_the_search({.target = "sqrt(x)", .form = "min(a x, b)", .over = {{"x", "0", "1"}}},
                                  {{1.5, 0.9}, {2, 0.8}});
}

TEST(PreparedStudy, FitsRows) {
  const auto rows = std::make_shared<MeasuredRows>(MeasuredRows{
      .file = {}, .places = {{0, 1, 2, 3, 4}}, .value = {1.1, 0.58, 0.41, 0.18, 0.15}, .sigma = {}});
  expect_the_answer_of_the_search(
      {.target = "", .form = "a exp(-b x)", .over = {{"x", "", ""}}, .rows = rows}, {{1, 0.5}, {2, 1}});
}

TEST(PreparedStudy, SaysWhyAStartHasNoAnswer) {
  PreparedStudy prepared({.target = "exp(-x)", .form = "log(a + x)", .over = {{"x", "0", "1"}}});
  const StudyFit fit = prepared.fit({-3});
  EXPECT_NE(fit.status, Status::converged);
  EXPECT_FALSE(fit.why.empty());
}

// b is 1 there, and no square in double tells.
TEST(PreparedStudy, RefusesNumbersThatNeedUnits) {
  EXPECT_EQ(testing::refusal([] {
              PreparedStudy({.target = "exp(x)", .form = "a + b x", .over = {{"x", "0", "1e-200"}}});
            }),
            "--over 'x': its range, the target or a parameter is too far from 1; write them in other units");
}

// sin(5 x) is the bottom of a basin of its own.
TEST(PreparedStudy, StartsThatLeadToDifferentCurvesAreNoAnswer) {
  PreparedStudy wave({.target = "sin(12*x)", .form = "sin(a*x)", .over = {{"x", "0", "3"}}});
  EXPECT_EQ(wave.fit_from({{12.1}, {11.9}}).status, Status::converged);
  EXPECT_EQ(wave.fit_from({{12.1}, {5}}).status, Status::ambiguous);
}

// Over a width of 1e-10 a line and a parabola are the same.
TEST(PreparedStudy, NamesParametersThatChangeTogether) {
  PreparedStudy narrow(
      {.target = "(1-c)^5", .form = "exp2((a c + b) c)", .over = {{"c", "0.5", "0.5000000001"}}});
  const StudyFit fit = narrow.fit({-5, -7});
  EXPECT_EQ(fit.status, Status::degenerate);
  EXPECT_NE(fit.why.find("a, b change together"), std::string::npos) << fit.why;
}

}  // namespace
}  // namespace shadefit
