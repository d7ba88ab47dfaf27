#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "fit/exchange/minimax_study.hpp"
#include "fit/squares/solve_study.hpp"
#include "fit/study/study.hpp"
#include "fit/support/user_error.hpp"
#include "fit/verdicts/study_objectives.hpp"
#include "tests/refusal.hpp"

/// Forms that are linear in many parameters, whose columns are nearly dependent.
namespace shadefit {
namespace {

double binomial(int n, int k) {
  double result = 1;
  for (int i = 1; i <= k; ++i) result = result * (n - k + i) / i;
  return result;
}

// x^n less its best polynomial of degree n - 1 on [0, 1] is the shifted Legendre polynomial divided by its
// first coefficient, binomial(2n, n) (Abramowitz, Stegun 1964, Handbook of Mathematical Functions, 22.2.11
// and 22.3.8).
TEST(LinearStudy, APowerLessItsBestPolynomialIsLegendres) {
  for (const int n : {8, 11}) {
    Study study{.target = "x^" + std::to_string(n), .form = "p00", .over = {{"x", "0", "1"}}};
    for (int k = 1; k < n; ++k)
      study.form += " + p" + std::string(k < 10 ? "0" : "") + std::to_string(k) + " x^" + std::to_string(k);
    const StudyFit fit = solve_study(read_study(study), {});
    ASSERT_EQ(fit.status, Status::converged) << n << ": " << fit.why;
    EXPECT_TRUE(fit.is_global);
    const double first = binomial(2 * n, n);
    // Of degree 10 the columns have the condition 1e7 and more, and long double has 19 digits.
    EXPECT_GE(fit.digits, n == 8 ? 11 : 8);
    for (int k = 0; k < n; ++k) {
      const double sign = (n + k) % 2 == 0 ? -1 : 1;
      const double expected = sign * binomial(n, k) * binomial(n + k, k) / first;
      EXPECT_NEAR(fit.parameters[static_cast<std::size_t>(k)] / expected, 1, std::pow(10, -fit.digits))
          << "p" << k << " of " << n;
    }
    // of errors of 1e-7 beside values of 1, which double rounds by 1e-16 and long double by 1e-19
    EXPECT_NEAR(fit.rms_error * first * std::sqrt(2 * n + 1), 1, 1e-6) << n;
  }
}

// x + 1 and 2 x + 2 are one column.
TEST(LinearStudy, DependentColumnsAreNamed) {
  const Study study{.target = "exp(x)", .form = "a (x + 1) + b (2 x + 2)", .over = {{"x", "0", "1"}}};
  const StudyFit fit = solve_study(read_study(study), {});
  EXPECT_EQ(fit.status, Status::degenerate);
  EXPECT_EQ(fit.why, "the curve stays the same while a, b change together");
}

// The integral of x^(-2p) on [0, 1] is 1/(1 - 2p), and there is none from p = 1/2 on. That of 1/(x + y)^2 on
// the square has no value either: near the corner it is that of 1/r.
TEST(LinearStudy, ATargetWithoutAMeanSquareIsRefusedWithItsPlace) {
  const StudyRange x{"x", "0", "1"}, y{"y", "0", "1"};
  const auto refusal = [](const Study& study) {
    const std::string text = testing::refusal([&] { solve_study(read_study(study), {}); });
    return text.substr(0, text.find(','));
  };
  const std::string form = "a + b x";
  for (const char* target : {"1/x", "1/sqrt(x)", "x^-0.6", "1/sin(x)"})
    EXPECT_EQ(refusal({.target = target, .form = form, .over = {x}}), "--target is not finite at x = 0")
        << target;
  for (const char* target : {"log(x)", "x^-0.4", "sqrt(x)", "x/sin(x)", "exp(3e12 log(1 - x))"})
    EXPECT_EQ(refusal({.target = target, .form = form, .over = {x}}), "") << target;
  EXPECT_NE(refusal({.target = "exp(1/x)", .form = form, .over = {x}}), "");
  EXPECT_EQ(refusal({.target = "1/(1 - x)", .form = form, .over = {x}}), "--target is not finite at x = 1");
  EXPECT_EQ(refusal({.target = "tan(x)", .form = form, .over = {{"x", "0", "3"}}}).substr(0, 43),
            "--target is not finite at x = 1.57079632679");
  EXPECT_EQ(refusal({.target = "1/(x y)", .form = form, .over = {x, y}}), "--target is not finite at y = 0");
  EXPECT_EQ(refusal({.target = "1/(x + y)", .form = form, .over = {x, y}}),
            "--target is not finite at x = 0");
}

// The largest error of a form that grows without bound is infinite; its square may have an integral.
TEST(LinearStudy, AFormWithoutAMeanSquareIsRefusedWithItsPlace) {
  const auto refusal = [](const std::string& form, const auto& solve) {
    const Study study{.target = "x", .form = form, .over = {{"x", "0", "1"}}};
    const std::string text = testing::refusal([&] { solve(read_study(study)); });
    return text.substr(0, text.find_first_of(",:"));
  };
  const auto least_squares = [](const ReadStudy& study) { solve_study(study, {}); };
  const auto minimax = [](const ReadStudy& study) { solve_minimax_study(study, {}, {}); };
  for (const std::string form : {"a/x + b", "a/x^0.6 + b", "a/sin(x) + b"}) {
    EXPECT_EQ(refusal(form, least_squares), "--form is not finite at x = 0") << form;
    EXPECT_EQ(refusal(form, minimax), "--form is not finite at x = 0") << form;
  }
  for (const std::string form : {"a log(x) + b", "a/x^0.4 + b", "a/log(x/2) + b x", "a sin(x)/x + b"})
    EXPECT_EQ(refusal(form, least_squares), "") << form;
  EXPECT_EQ(refusal("a log(x) + b", minimax), "--form is not finite at x = 0");
  EXPECT_EQ(refusal("a sin(x)/x + b", minimax), "");
}

// Roots, logarithms and kinks across several variables. The moments of the targets on the square and the cube
// are closed forms, as E |x - y z| = 13/36; the normal equations of a + b x + d y give the rest.
TEST(LinearStudy, IntegratesSingularEdgesOfSeveralVariables) {
  struct Known {
    std::string target;
    bool has_z;
    std::vector<double> parameters;
    int digits;
  };
  const double pi = std::acos(-1.0), root = std::sqrt(2.0);
  // E |x^2 + y^2 - 1/2| = 1/6 + pi/16, and E x |x^2 + y^2 - 1/2| = 1/6 + sqrt(2)/30.
  const double mean = 1.0 / 6 + pi / 16, slope = 12 * (1.0 / 6 + root / 30 - mean / 2);
  const std::vector<Known> all{
      {"sqrt(x y)", false, {-4.0 / 45, 8.0 / 15, 8.0 / 15}, 13},
      {"log(x y)", false, {-5, 3, 3}, 13},
      {"sqrt(x y z)", true, {-8.0 / 135, 16.0 / 45, 16.0 / 45}, 12},
      {"abs(x - y z)", true, {11.0 / 72, 7.0 / 12, -1.0 / 6}, 7},
      {"abs(x^2 + y^2 - 1/2)", false, {mean - slope, slope, slope}, 9},
  };
  for (const auto& [target, has_z, parameters, digits] : all) {
    Study study{.target = target, .form = "a + b x + d y", .over = {{"x", "0", "1"}, {"y", "0", "1"}}};
    if (has_z) study.over.push_back({"z", "0", "1"});
    const StudyFit fit = solve_study(read_study(study), {});
    ASSERT_EQ(name(fit.status), "converged") << target << ": " << fit.why;
    EXPECT_GE(fit.digits, digits) << target;
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(fit.parameters[i] / parameters[i], 1, std::max(1e-14, std::pow(10, -fit.digits)))
          << target << ", " << fit.names[i];
  }
}

// With the density 1/x, the normal equations of x^2 ~ a x + b x^3 are those of x ~ a + b x^2 with the density
// x: 1/2 a + 1/4 b = 1/3, 1/4 a + 1/6 b = 1/5. The density itself has no integral.
TEST(LinearStudy, ADensityNeedsNoIntegralWhereTheErrorVanishes) {
  const StudyFit fit =
      solve_study(read_study({.target = "x^2", .form = "a x + b x^3", .over = {{"x", "0", "1", "1/x"}}}), {});
  ASSERT_EQ(fit.status, Status::converged) << fit.why;
  EXPECT_NEAR(fit.parameters[0], 4.0 / 15, 1e-15);
  EXPECT_NEAR(fit.parameters[1], 4.0 / 5, 1e-15);
}

// Long double leaves nothing of x^2 beside 1. Of a steep smooth step b = -3/2 + 2 (pi/100)^2, of a hypotenuse
// a = 2 sqrt(2) - 5/2.
TEST(LinearStudy, KeepsItsDigitsInAnyUnits) {
  const double pi = std::acos(-1.0), slope = -1.5 + 2 * pi * pi * 1e-4;
  const auto fitted = [](const Study& study) { return fit_study({"", study, Norm::least_squares, {}}); };
  const std::vector<std::pair<Study, std::vector<double>>> all{
      {{"1 + x^2", "a + b x^2", {{"x", "0", "1e-12"}}}, {1, 1}},
      {{"1 + x^2", "a + b x^2", {{"x", "1e6", "1000001"}}}, {1, 1}},
      {{"1e-200 (2 + (x/1e50)^2)", "a + 2^1 b x^2", {{"x", "0", "1e50"}}}, {2e-200, 5e-301}},
      {{"max(0.25, x)/(x - 1) + 2 x", "a + b x", {{"x", "1e-12", "1e-9"}}}, {-0.25, 1.75 - 2.5025e-10}},
      {{"1/(1 + exp((x - 0.5)/0.01))", "a + b x", {{"x", "0", "1"}}}, {0.5 - slope / 2, slope}},
      {{"hypot(x, y)", "max(x, y) + a min(x, y)", {{"x", "0", "1"}, {"y", "0", "1"}}}, {std::sqrt(8) - 2.5}}};
  for (const auto& [study, parameters] : all) {
    const StudyFit fit = fitted(study);
    ASSERT_EQ(name(fit.status), "converged") << study.target << ": " << fit.why;
    EXPECT_EQ(fit.digits, 14) << study.target;
    for (std::size_t i = 0; i < parameters.size(); ++i)
      EXPECT_NEAR(fit.parameters[i] / parameters[i], 1, 2e-14) << study.target;
  }
  EXPECT_EQ(fitted({"exp(x)", "a + b x", {{"x", "0", "1e-200"}}}).status, Status::not_converged);
}

}  // namespace
}  // namespace shadefit
