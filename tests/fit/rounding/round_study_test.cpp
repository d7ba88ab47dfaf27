#include "fit/rounding/round_study.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "fit/rounding/rounding.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

const NumberFormat single{NumberFormat::Kind::single};

NumberFormat decimals(int digits) {
  return {NumberFormat::Kind::decimal, digits};
}

RoundedStudy rounded(const Study& study, Norm norm, const NumberFormat& format) {
  const StudyObjective objective = objective_of(study, norm, {});
  return round_study(objective, fit_study(objective), format);
}

const Study fresnel_pair{.target = "(1 - c)^5", .form = "exp2((a c + b) c)", .over = {{"c", "0", "1"}}};
const Study line_of_square{.target = "x^2", .form = "a + b x", .over = {{"x", "0", "1"}}};

// Text and family: the same constants among all decimals of four digits.
TEST(RoundStudy, FindsTheConstantsOfTheFamily) {
  const RoundedStudy found = rounded(fresnel_pair, Norm::least_squares, decimals(4));
  const FittableFamily& family = *find_family("fresnel-quadratic");
  const Rounded expected = round_fit(family.fit({}, {}), decimals(4), {});
  EXPECT_EQ(found.best.texts, expected.best.texts);
  EXPECT_EQ(found.naive.texts, expected.naive.texts);
  EXPECT_TRUE(found.is_proven);
  EXPECT_NEAR(found.best.max_error / *expected.best.real_error, 1, 1e-6);
}

/// max |a + b x - x^2| on [0, 1]: at an end, or where b = 2 x.
double error_of_line(double a, double b) {
  const double inside = 0 <= b && b <= 2 ? std::abs(a + b * b / 4) : 0;
  return std::max({std::abs(a), std::abs(a + b - 1), inside});
}

// Every pair of decimals of two digits near the optimum, a = -1/8, b = 1, in a plain loop.
TEST(RoundStudy, NoOtherDecimalsAreBetter) {
  const RoundedStudy found = rounded(line_of_square, Norm::minimax, decimals(2));
  double best = 1;
  for (int i = -20; i <= -10; ++i) {
    for (int j = 80; j <= 120; ++j) {
      if (j > 100 && j % 10 != 0) continue;  // 1.01 has three digits
      best = std::min(best, error_of_line(i / 100.0, j / 100.0));
    }
  }
  EXPECT_TRUE(found.is_proven);
  EXPECT_NEAR(error_of_line(found.best.values[0], found.best.values[1]), best, 1e-15);
  EXPECT_GE(found.best.max_error, best * (1 - 1e-15));
  EXPECT_LE(found.best.max_error, best * (1 + 2e-6));
}

// More parameters than the whole lattice allows, a relative error, a held parameter, two variables.
TEST(RoundStudy, IsNeverWorseThanRoundingEachConstant) {
  Study rational{.target = "sqrt(x)", .form = "(a + b x)/(1 + d x)", .over = {{"x", "0.25", "1"}}};
  rational.error = Error::relative;
  Study held = fresnel_pair;
  held.held = {{"a", -5.5}};
  const Study plane{.target = "x y",
                    .form = "a + b x + d y",
                    .over = {{"x", "0", "1"}, {"y", "0", "1"}},
                    .weight = "1 + x"};
  for (const auto& [study, norm] :
       {std::pair{rational, Norm::minimax}, {held, Norm::least_squares}, {plane, Norm::least_squares}}) {
    for (const NumberFormat& format : {decimals(3), single}) {
      const RoundedStudy found = rounded(study, norm, format);
      EXPECT_LE(found.best.max_error, found.naive.max_error * (1 + 1e-6)) << study.form << to_text(format);
      EXPECT_GT(found.evaluated, 1);
      EXPECT_EQ(found.best.values.size(), read_study(study).parameters.size());
    }
  }
}

TEST(RoundStudy, RefusesWhatRoundingBreaks) {
  const auto refusal = [](const Study& study, const NumberFormat& format,
                          const Constraints& constraints = {}) {
    const StudyObjective objective = objective_of(study, Norm::minimax, constraints);
    try {
      round_study(objective, fit_study(objective), format);
    } catch (const UserError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusal(line_of_square, {NumberFormat::Kind::half}),
            "--round 'half' does not go with a study: take float or decimal:N");
  EXPECT_EQ(refusal(line_of_square, single, {.exact_at = {0}}),
            "--round 'float' does not go with a constraint: rounding would break it");
  Study quintic = line_of_square;
  quintic.form = "a + b x + d x^2 + g x^3 + h x^4";
  quintic.target = "exp(x)";
  EXPECT_EQ(refusal(quintic, single), "--round 'float' takes at most 4 parameters: the form has 5");
  Study large = line_of_square;
  large.form = "1e-40 a + b x";
  EXPECT_EQ(refusal(large, single), "--round 'float': a = -1.25e+39 overflows: the largest is 3.40282e+38");
}

}  // namespace
}  // namespace shadefit
