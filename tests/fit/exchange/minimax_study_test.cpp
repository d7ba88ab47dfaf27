#include "fit/exchange/minimax_study.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "fit/squares/solve_study.hpp"
#include "fit/support/user_error.hpp"
#include "fit/verdicts/study_objectives.hpp"

/// Minimax fits of studies of one variable where the exchange is easily led astray.
namespace shadefit {
namespace {

StudyFit minimax_of(const Study& study) {
  return solve_minimax_study(read_study(study), {}, {});
}

// Least squares finds a = 1, b = 50, where the error is 0. A sine of another frequency has the level 1.
TEST(MinimaxStudy, CallsNoWorseLevelConverged) {
  const Study wave{.target = "sin(50 x)", .form = "a sin(b x)", .over = {{"x", "0", "1"}}};
  const StudyFit exact = minimax_of(wave);
  EXPECT_NE(name(exact.status), "converged") << *exact.level;
  EXPECT_NEAR(exact.parameters[0] * exact.parameters[1], 50, 1e-9);
  Study disturbed = wave;
  disturbed.target = "sin(50 x) + x/10";
  const StudyFit fit = minimax_of(disturbed);
  if (fit.status == Status::converged) {
    EXPECT_LT(*fit.level, 0.11);
  }
}

// At x = 0 both are 0, and the relative error is the limit a - 1. The alternation is 0, a place inside and 1;
// mpmath solved its equations by `findroot` in 40 digits.
TEST(MinimaxStudy, TakesTheLimitOfARelativeErrorAtAZeroOfTheTarget) {
  struct Known {
    std::string target, form;
    std::vector<double> parameters;
    double level;
  };
  const std::vector<Known> all{
      {"sin(x)", "a x + b x^2", {1.020284228885116605606, -0.1617446540211922482231}, 0.0202842288851166056},
      {"log(1 + x)",
       "a x + b x^2",
       {0.9784623833280494347519, -0.3002439410402475321673},
       0.02153761667195056525},
      {"sqrt(sin(x))",
       "sqrt(x) (a + b x)",
       {1.010608150810509439204, -0.08355983482773987912556},
       0.01060815081050943920}};
  for (const auto& [target, form, parameters, level] : all) {
    const StudyFit fit =
        minimax_of({.target = target, .form = form, .over = {{"x", "0", "1"}}, .error = Error::relative});
    ASSERT_EQ(name(fit.status), "converged") << target << ": " << fit.why;
    for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(fit.parameters[i] / parameters[i], 1, 1e-12) << target;
    EXPECT_NEAR(*fit.level / level, 1, 1e-11) << target;
  }
}

// The level is 14 digits below the target: long double leaves it five, and the last parameter eight. By
// Remez' exchange in 60 digits with mpmath, which solved the system at the places and moved them by Newton's
// method.
TEST(MinimaxStudy, FindsALevelNearTheRoundingOfTheTarget) {
  const StudyFit fit = minimax_of({.target = "expm1(x)/x",
                                   .form = "a + b x + d x^2 + g x^3",
                                   .over = {{"x", "-0.001953125", "0.001953125"}}});
  ASSERT_EQ(name(fit.status), "converged") << fit.why;
  constexpr auto rounding = static_cast<double>(std::numeric_limits<long double>::epsilon());
  EXPECT_NEAR(*fit.level, 1.5158247496252334e-14, 2 * rounding);  // two roundings of 1
  const std::vector<double> right{0.99999999999998484, 0.49999999999998989, 0.16666669845581322,
                                  0.04166667461395330};
  ASSERT_GE(fit.digits, 6);
  for (std::size_t i = 0; i < right.size(); ++i)
    EXPECT_NEAR(fit.parameters[i] / right[i], 1, std::pow(10.0, -fit.digits)) << i << ", " << fit.digits;
}

// Without a limit the place is named.
TEST(MinimaxStudy, NamesAZeroOfTheTargetThatTheFormDoesNotShare) {
  for (const char* form : {"a + b x", "a x + b sqrt(x)"}) {
    try {
      minimax_of({.target = "sin(x)", .form = form, .over = {{"x", "0", "1"}}, .error = Error::relative});
      FAIL() << form;
    } catch (const UserError& error) {
      EXPECT_STREQ(
          error.what(),
          "--error 'relative' divides by the target, which is 0 at x = 0: leave that place out of --over")
          << form;
    }
  }
}

// The error of 1/(x - h) is a Chebyshev polynomial of degree 2, which has its level at three places with
// alternating signs: no other quotient is better. a = d = -1/h, but least squares has positive ones. On the
// way the level falls until both are infinite, and beyond that they are negative.
TEST(MinimaxStudy, GoesBeyondInfinity) {
  for (const double h : {0.01, 0.02}) {
    for (const double level : {0.02, 0.05, 0.1}) {
      const std::string bump = std::to_string(level) + " (8 (x - 1.5)^2 - 1)";
      const Study study{.target = "1/(x - " + std::to_string(h) + ") - " + bump,
                        .form = "a/(1 + d x)",
                        .over = {{"x", "1", "2"}}};
      EXPECT_GT(solve_study(read_study(study), {}).parameters.front(), 0) << bump;
      const StudyFit fit = minimax_of(study);
      ASSERT_EQ(name(fit.status), "converged") << bump << ": " << fit.why;
      for (const double parameter : fit.parameters) EXPECT_NEAR(parameter * -h, 1, 1e-11) << bump;
      EXPECT_NEAR(*fit.level / level, 1, 1e-12) << bump;
    }
  }
}

// The error of max(a x - b, 0) is -b^2/a^2 at its kink, a^2/4 - b at x = a/2, and a - b - 1 at x = 1. These
// are -r^2, r^2 and -r^2 for r = 1/(1 + 2 sqrt(2)): then b/a = r, and a = 1 + r.
TEST(MinimaxStudy, LevelsAnErrorAtAKinkThatMoves) {
  const StudyFit fit = minimax_of({.target = "x^2", .form = "max(a x - b, 0)", .over = {{"x", "0", "1"}}});
  ASSERT_EQ(name(fit.status), "converged") << fit.why;
  const double r = 1 / (1 + 2 * std::sqrt(2.0));
  EXPECT_NEAR(fit.parameters[0], 1 + r, 1e-14);
  EXPECT_NEAR(fit.parameters[1], r * (1 + r), 1e-14);
  EXPECT_NEAR(*fit.level / (r * r), 1, 1e-14);
  ASSERT_EQ(fit.alternation.size(), 3);
  EXPECT_NEAR(fit.alternation.front().at.cos_theta, r, 1e-12);
}

// (1 - x)^37 and exp(-b x) fall to 1e-37 and below: their logarithms tell which is larger. Where the form
// touches target or bound at the end of the range, b is a quotient of logarithms.
TEST(MinimaxStudy, KeepsAnExponentialToItsSideWhereItIsNextToNothing) {
  const Study lobe{.target = "(1-x)^37", .form = "exp(-b x)", .over = {{"x", "0", "0.9"}}};
  const StudyFit below = solve_minimax_study(read_study(lobe), {.one_sided = Side::below}, {});
  ASSERT_EQ(below.status, Status::converged) << below.why;
  EXPECT_NEAR(below.parameters[0], 37 * std::log(10.0) / 0.9, 1e-12);
  Study whole = lobe;
  whole.over.front().upper = "1";
  const StudyFit bounded = solve_minimax_study(read_study(whole), {.at_least = 1e-6}, {});
  ASSERT_EQ(bounded.status, Status::converged) << bounded.why;
  EXPECT_NEAR(bounded.parameters[0], 6 * std::log(10.0), 1e-12);
  EXPECT_THROW(solve_minimax_study(read_study(whole), {.one_sided = Side::below}, {}), UserError)
      << "at x = 1 the target is 0, and the form is not";
  // The scale may not be positive; then the form has no logarithm.
  Study scaled = lobe;
  scaled.target = "-(1-x)^37";
  scaled.form = "a exp(-b x)";
  EXPECT_EQ(solve_minimax_study(read_study(scaled), {}, {}).status, Status::converged);
}

// The target is negative from x = 1/2 on, where it asks for nothing: the form touches it at x = 0 alone.
TEST(MinimaxStudy, KeepsAnExponentialAboveATargetThatChangesSign) {
  const Study study{.target = "(0.5 - x)^3", .form = "exp(b - x)", .over = {{"x", "0", "1"}}};
  const StudyFit fit = solve_minimax_study(read_study(study), {.one_sided = Side::above}, {});
  ASSERT_EQ(fit.status, Status::converged) << fit.why;
  EXPECT_NEAR(fit.parameters[0], std::log(0.125), 1e-13);
}

// Of glass from inside, whose target is 1 up to the critical angle: (1-c)^4/(1 + a c) comes nearer and nearer
// as a falls, until its pole enters the range.
TEST(MinimaxStudy, StaysOnItsSideOfAPole) {
  Study inside{.target = "weight_of_reflectance(dielectric_reflectance(c, n), reflectance_at_normal(n))",
               .form = "(1-c)^4/(1 + a c)",
               .over = {{"c", "0", "1"}},
               .given = {{"n", "0.485"}}};
  const StudyFit squares = fit_study({.study = inside});
  EXPECT_EQ(squares.status, Status::at_border);
  EXPECT_NE(squares.why.find("a pole of the form, at c = 0.998"), std::string::npos) << squares.why;
  inside.over.front().upper = "0.8";
  const StudyFit minimax = fit_study({.study = inside, .norm = Norm::minimax});
  ASSERT_EQ(minimax.status, Status::converged) << minimax.why;
  // The errors at c = -(4 + a)/(3 a), where the form is least, and at 0.8 are opposite: mpmath in 30 digits.
  EXPECT_NEAR(minimax.parameters[0], -1.24896900203307486, 1e-13);
  EXPECT_NEAR(*minimax.level, 0.93986803481758444, 1e-13);
}

// The error of a quotient in sqrt(x) for PQ has an extremum at x = 1e-13 that the panels do not show: with
// the level of the others, 0.000490904, it is 0.000491732 there.
TEST(MinimaxStudy, GoesOnWhereItsPanelsMissTheLargestError) {
  const Study pq{.target = "pow((3424/4096 + 2413/128*k)/(1 + 2392/128*k), 2523/32)",
                 .form = "(s*(s*(s*a + b) + d) + f)/(s*(s*(s*l + m) + n) + 1)",
                 .over = {{"x", "0", "14"}},
                 .definitions = {{"k", {}, "pow(x/100, 2610/16384)"}, {"s", {}, "sqrt(x)"}}};
  const StudyFit fit = minimax_of(pq);
  ASSERT_EQ(fit.status, Status::converged) << fit.why;
  EXPECT_LT(*fit.level, 0.0004913);
  EXPECT_NEAR(fit.max_abs_error.magnitude / *fit.level, 1, 1e-9);
}

}  // namespace
}  // namespace shadefit
