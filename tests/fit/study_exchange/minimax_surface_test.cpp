#include "fit/study_exchange/minimax_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "fit/fit.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/study_exchange/minimax_study.hpp"
#include "fit/study_proof/study_certificate.hpp"
#include "fit/support/hex_float.hpp"
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

TEST(MinimaxSurface, FindsWhatIsKnown) {
  for (const KnownSurface& known : known_surfaces()) {
    const StudyFit fit = fit_of(known.study);
    EXPECT_EQ(name(fit.status), "converged") << known.name << ": " << fit.why;
    EXPECT_TRUE(fit.is_global) << known.name;
    ASSERT_EQ(fit.parameters.size(), known.parameters.size()) << known.name;
    for (std::size_t i = 0; i < fit.parameters.size(); ++i)
      EXPECT_NEAR(fit.parameters[i], known.parameters[i], 1e-14) << known.name << ", " << fit.names[i];
    EXPECT_NEAR(*fit.level / known.level, 1, 1e-14) << known.name;
    EXPECT_NEAR(fit.max_abs_error.magnitude / known.level, 1, 1e-9) << known.name;
  }
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
    StudySubject subject{study};
    for (std::size_t i = 0; i < fit.names.size(); ++i)
      subject.parameters.emplace_back(fit.names[i], hex_text(fit.parameters[i]));
    const StudyCertificate proven = certify_study(subject, 1e-4).certificate;
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

TEST(MinimaxSurface, SaysWhereItHasNoAnswer) {
  // At x = 1 the error is a + b - y: the level is 1/2 for a from -1/2 to 1/2.
  const StudyFit open = fit_of({.target = "x y", .form = "a + b x", .over = square});
  EXPECT_EQ(name(open.status), "degenerate");
  EXPECT_EQ(open.why, "the level, 0.5, is the least, but other parameters have it too");
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
