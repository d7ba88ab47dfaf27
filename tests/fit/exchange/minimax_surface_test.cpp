#include "fit/exchange/minimax_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "fit/bounds/study_certificate.hpp"
#include "fit/catalogue/family.hpp"
#include "fit/exchange/minimax_study.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

const std::vector<StudyRange> square{{"x", "0", "1"}, {"y", "0", "1"}};
const std::vector<StudyRange> cube{{"x", "0", "1"}, {"y", "0", "1"}, {"z", "0", "1"}};

StudyFit fit_of(const Study& study) {
  return solve_minimax_study(read_study(study), {}, {});
}

/// A fit whose answer is known.
struct KnownSurface {
  const char* name;
  Study study;
  std::vector<double> parameters;
  double level;
};

std::vector<KnownSurface> known_surfaces() {
  // exp(t) by a line on [0, 1] has the slope of the chord. The level is half the largest distance from it, at
  // t = log(e - 1).
  const double e = std::exp(1.0);
  const double line_level = (2 - e + (e - 1) * std::log(e - 1)) / 2;
  return {
      // The errors of the four corners, with the signs + - - +, add up to 1 for every plane.
      {"a saddle by a plane",
       {.target = "x y", .form = "a + b x + d y", .over = square},
       {-0.25, 0.5, 0.5},
       0.25},
      // In each variable it is Chebyshev's line. Five tops hold the level, one more than are needed.
      {"a bowl by a plane",
       {.target = "x^2 + y^2", .form = "a + b x + d y", .over = square},
       {-0.25, 1, 1},
       0.25},
      {"a bowl in three variables",
       {.target = "x^2 + y^2 + z^2", .form = "a + b x + d y + f z", .over = cube},
       {-0.375, 1, 1, 1},
       0.375},
      // On the edge x = 1 it is exp(y) by a line. With a + d x y no error is larger than there.
      {"a ridge of tops",
       {.target = "exp(x y)", .form = "a + b x + c y + d x y", .over = square},
       {1 - line_level, 0, 0, e - 1},
       line_level},
      {"a variable without a part in it", {.target = "x", .form = "a + b y", .over = square}, {0.5, 0}, 0.5},
  };
}

void expect_known(const KnownSurface& known, bool is_unique) {
  const StudyFit fit = fit_of(known.study);
  ASSERT_EQ(name(fit.status), "converged") << known.name << ": " << fit.why;
  EXPECT_EQ(fit.is_unique, is_unique) << known.name;
  EXPECT_TRUE(fit.is_global) << known.name;
  ASSERT_EQ(fit.parameters.size(), known.parameters.size()) << known.name;
  for (std::size_t i = 0; i < fit.parameters.size(); ++i)
    EXPECT_NEAR(fit.parameters[i], known.parameters[i], 1e-14) << known.name << ", " << fit.names[i];
  EXPECT_NEAR(*fit.level / known.level, 1, 1e-14) << known.name;
  EXPECT_NEAR(fit.max_abs_error.magnitude / known.level, 1, 1e-9) << known.name;
}

TEST(MinimaxSurface, FindsWhatIsKnown) {
  for (const KnownSurface& known : known_surfaces()) expect_known(known, true);
}

// Without a known answer: the errors of the contacts are the level, and the proof of the largest error, which
// shares only the formulas, agrees.
TEST(MinimaxSurface, HasTheLevelThatIsProven) {
  const std::vector<Study> studies{
      {.target = "sqrt(1 + x + 2 y)", .form = "(a + b x + d y)/(1 + f x + g y)", .over = square},
      {.target = "log(1 + x + y)", .form = "(a x + b y)/(1 + d x + f y)", .over = square},
      {.target = "cos(x) cos(y)", .form = "a + b (x^2 + y^2) + d x^2 y^2", .over = square},
  };
  for (const Study& study : studies) {
    const StudyFit fit = fit_of(study);
    ASSERT_EQ(name(fit.status), "converged") << study.form << ": " << fit.why;
    EXPECT_EQ(fit.touching.size(), fit.parameters.size() + 1) << study.form;
    for (const StudyContact& contact : fit.touching)
      EXPECT_NEAR(std::abs(contact.error) / *fit.level, 1, 1e-12) << study.form;
    const StudyCertificate proven = certify_study({study, constants_of(study, fit)}, 1e-4).certificate;
    EXPECT_LE(proven.lower, *fit.level * (1 + 1e-4)) << study.form;
    EXPECT_GE(proven.upper, *fit.level * (1 - 1e-4)) << study.form;
  }
}

// No plane beside it is better.
TEST(MinimaxSurface, IsALeastLevel) {
  const Study study{.target = "exp(x - y^2)", .form = "a + b x + d y", .over = square};
  const StudyFit fit = fit_of(study);
  ASSERT_EQ(name(fit.status), "converged") << fit.why;
  const ReadStudy read = read_study(study);
  for (std::size_t i = 0; i < 3; ++i) {
    for (const double step : {-1e-4, 1e-4}) {
      std::vector<double> beside = fit.parameters;
      beside[i] += step;
      EXPECT_GT(largest_weighted_error(read, beside).magnitude, *fit.level * (1 + 1e-6)) << i << step;
    }
  }
}

// Fewer tops than parameters hold these levels. Of all parameters with the level those with the least mean
// square are the answer.
TEST(MinimaxSurface, ChoosesTheLeastSquareOfManyWithTheLeastLevel) {
  // At x = 1 the error is a + b - y: the level is 1/2 if a + b = 1/2. Then it is x (1/2 - y) + a (1 - x),
  // whose parts are orthogonal.
  const KnownSurface plane{"a plane", {.target = "x y", .form = "a + b x", .over = square}, {0, 0.5}, 0.5};
  // Burley's diffuse reflection. At x = 0 the target is a parabola in r with r^2 5/72, the form a line: the
  // level is 5/576, for a - b and d alone. The error has a place at (0, 1), so it may not fall from there: g
  // is the target's slope by x. The other three solve the normal equations, in fractions.
  const std::string q = "(1 - y)^5", once = "(x - 1/2)*(1/21 + " + q + ") + x y (1/84 + 2/3*" + q + ")",
                    twice = "(x - 1/2)^2/21 + (x - 1/2)*x y/42 + x^2*(11/504 - y^2*(1/56))";
  const double b = 944134631.0 / 1903487040;
  const KnownSurface albedo{"an albedo",
                            {.target = "1 + " + once + " + " + q + "*(" + twice + ")",
                             .form = "lerp(a - b*(1 - y)^5, d + (g + (h + k y) y) y, x)",
                             .over = square},
                            {1933.0 / 4032 + b, b, 6245.0 / 4032, -997.0 / 504, 251579099333.0 / 100504115712,
                             -4984463353.0 / 4785910272},
                            5.0 / 576};
  for (const KnownSurface& known : {plane, albedo}) expect_known(known, false);
}

// Nine tops hold this level, where twelve would determine eleven parameters by their slopes. SciPy's level at
// 161 x 161 places is 0.018332526, from four starts (tests/references/sheen_minimax.py). It is below that of
// all places, where the error is higher between them: by up to the square of their distance, 1e-4.
TEST(MinimaxSurface, CurvatureDeterminesWhatTheTopsLeaveOpen) {
  const Study study{.target = "imageworks_sheen_albedo(x, y)",
                    .form = "(a + b x + d y + f x y + g x^2 + h y^2)/(c + j x + k y + l x y + m x^2 + y^2)",
                    .over = {{"x", "0.02", "1"}, {"y", "0.05", "1"}}};
  const StudyFit fit = fit_of(study);
  ASSERT_EQ(name(fit.status), "converged") << fit.why;
  EXPECT_TRUE(fit.is_unique);
  EXPECT_EQ(fit.touching.size(), 9U);
  constexpr double at_places = 0.018332526;
  EXPECT_GT(*fit.level, at_places);
  EXPECT_LT(*fit.level, at_places * (1 + 1e-4));
  EXPECT_NEAR(fit.max_abs_error.magnitude / *fit.level, 1, 1e-8);
  const ReadStudy read = read_study(study);
  for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
    for (const double factor : {1 - 1e-3, 1 + 1e-3}) {
      std::vector<double> beside = fit.parameters;
      beside[i] *= factor;
      EXPECT_GT(largest_weighted_error(read, beside).magnitude, *fit.level) << fit.names[i] << factor;
    }
  }
}

TEST(MinimaxSurface, SaysWhereItHasNoAnswer) {
  const StudyFit same = fit_of({.target = "x y + 1", .form = "a x y + b", .over = square});
  EXPECT_EQ(name(same.status), "degenerate") << same.why;

  const auto refusal = [](const Study& study, const Constraints& constraints) -> std::string {
    try {
      solve_minimax_study(read_study(study), constraints, {});
    } catch (const UserError& error) {
      return error.what();
    }
    return "none";
  };
  const Study plane{.target = "x y", .form = "a + b x", .over = square};
  EXPECT_EQ(refusal(plane, {.exact_at = {0}}),
            "--exact-at needs a study of one variable: this one also has 'y'");
  EXPECT_EQ(refusal(plane, {.one_sided = Side::above}),
            "--one-sided needs a study of one variable: this one also has 'y'");
}

// Chebyshev: x^15 by a polynomial of degree 14 on [-1, 1] has the level 2^-14.
TEST(MinimaxStudy, TakesFifteenParameters) {
  std::string form = "c0";
  for (int i = 1; i < 15; ++i) form += " + c" + std::to_string(i) + " x^" + std::to_string(i);
  const StudyFit fit = fit_of({.target = "x^15", .form = form, .over = {{"x", "-1", "1"}}});
  EXPECT_EQ(name(fit.status), "converged") << fit.why;
  EXPECT_NEAR(fit.level.value_or(0), std::ldexp(1.0, -14), 1e-15);
}

}  // namespace
}  // namespace shadefit
