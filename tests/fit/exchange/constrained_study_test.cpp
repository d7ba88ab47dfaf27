#include "fit/exchange/constrained_study.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "fit/catalogue/family.hpp"
#include "fit/exchange/minimax_study.hpp"
#include "fit/scalars/jet.hpp"
#include "fit/squares/rules.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

Study study_of(const char* target, const char* form, const char* lower = "0", const char* upper = "1") {
  return {.target = target, .form = form, .over = {{"x", lower, upper}}};
}

StudyFit fit_of(const Study& study, const Constraints& constraints) {
  return solve_constrained_study(read_study(study), constraints, {});
}

/// A fit under constraints whose answer is known.
struct KnownFit {
  const char* name;
  Study study;
  Constraints constraints;
  std::vector<double> parameters;
  std::size_t touching;
};

std::vector<KnownFit> known_fits() {
  return {
      // b is the mean of x (e^x - 1) over that of x^2.
      {"exact at an end", study_of("exp(x)", "a + b x"), {.exact_at = {0}}, {1, 1.5}, 1},
      // A tangent at t leaves (x - t)^2, whose square is least for t = 1/2.
      {"below a parabola", study_of("x^2", "a + b x"), {.one_sided = Side::below}, {-0.25, 1}, 1},
      // With u = 1 - x the form is 1/2 - b u, and (1 - b) u - 1/2 is least for 1 - b = 3/4.
      {"at most a half", study_of("x", "a + b x"), {.at_most = 0.5}, {0.25, 0.25}, 1},
      {"at least a half", study_of("x", "a + b x"), {.at_least = 0.5}, {0.5, 0.25}, 1},
      {"between two bounds", study_of("x", "a + b x"), {.at_most = 0.7, .at_least = 0.5}, {0.5, 0.2}, 2},
      // Of the lines that fall the mean is nearest.
      {"a rising target by a falling line",
       study_of("x", "a + b x"),
       {.monotone = Course::falls},
       {0.5, 0},
       1},
      // b >= 2 |d|. With b = 2 d and a = (1 - d)/3 the square is 8/3 d^2 + 8/45 (1 - d)^2.
      {"a bowl by a rising parabola",
       study_of("x^2", "a + b x + d x^2", "-1", "1"),
       {.monotone = Course::rises},
       {5.0 / 16, 1.0 / 8, 1.0 / 16},
       1},
      // Near x = 1 both are a multiple of sqrt(1 - x): sqrt(2) for the arc cosine.
      {"above the arc cosine at its root, and exact",
       study_of("acos(x)", "sqrt(1-x) (a + b x)"),
       {.exact_at = {0}, .one_sided = Side::above},
       {std::acos(0.0), std::sqrt(2.0) - std::acos(0.0)},
       2},
      // The slope at 0, where it is exact, decides: b - a/2 = -1.
      {"below the arc cosine, and exact",
       study_of("acos(x)", "sqrt(1-x) (a + b x)"),
       {.exact_at = {0}, .one_sided = Side::below},
       {std::acos(0.0), std::acos(0.0) / 2 - 1},
       2},
      {"a constraint that does not touch",
       study_of("exp(x)", "a + b x"),
       {.at_least = 0},
       {4 * std::exp(1.0) - 10, 18 - 6 * std::exp(1.0)},
       0},
  };
}

TEST(ConstrainedStudy, FindsWhatIsKnown) {
  for (const KnownFit& known : known_fits()) {
    const StudyFit fit = fit_of(known.study, known.constraints);
    ASSERT_EQ(name(fit.status), "converged") << known.name << ": " << fit.why;
    EXPECT_GE(fit.digits, 13) << known.name;
    EXPECT_TRUE(fit.is_global) << known.name;
    ASSERT_EQ(fit.parameters.size(), known.parameters.size()) << known.name;
    for (std::size_t i = 0; i < fit.parameters.size(); ++i)
      EXPECT_NEAR(fit.parameters[i], known.parameters[i], 2e-15) << known.name << ", " << fit.names[i];
    EXPECT_EQ(fit.alternation.size(), known.touching) << known.name;
  }
}

// Above a negative target is below its mirror image, also where the error is divided by the target. Both
// answers have 13 digits.
TEST(ConstrainedStudy, ANegativeTargetMirrorsAPositiveOne) {
  for (const Error error : {Error::absolute, Error::relative}) {
    for (const auto solve : {+[](const Study&s, Side side) { return fit_of(s, {.one_sided = side}); },
                             +[](const Study&s, Side side) {
                               return solve_minimax_study(read_study(s), {.one_sided = side}, {});
                             }}) {
      Study positive = study_of("exp(x)", "a + b x"), negative = study_of("-exp(x)", "a + b x");
      positive.error = negative.error = error;
      const StudyFit below = solve(positive, Side::below), above = solve(negative, Side::above);
      ASSERT_EQ(name(above.status), "converged") << above.why;
      for (std::size_t i = 0; i < 2; ++i)
        EXPECT_NEAR(above.parameters[i], -below.parameters[i], 1e-13)
            << name(error) << ", " << above.names[i];
    }
  }
}

/// By how much the form breaks a constraint at any of many places.
double violation(const Study& study, const Constraints& constraints, const std::vector<double>& parameters) {
  const ReadStudy read = read_study(study);
  using Jet = ceres::Jet<double, 1>;
  const auto along = [&](const Symbolic& formula, double x) {
    return evaluate<Jet>(formula, [&](const std::string& name) {
      for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (name == read.parameters[i]) return Jet(parameters[i]);
      }
      return Jet(x, 0);
    });
  };
  double worst = 0;
  constexpr int places = 400;
  for (int i = 0; i <= places; ++i) {
    const StudyAxis& axis = read.axes.front();
    const double x = axis.lower + (axis.upper - axis.lower) * i / places;
    const Jet form = along(read.form, x), target = along(read.target, x);
    if (constraints.one_sided)
      worst = std::max(worst, (form.a - target.a) * (*constraints.one_sided == Side::above ? -1 : 1));
    if (constraints.at_most) worst = std::max(worst, form.a - *constraints.at_most);
    if (constraints.at_least) worst = std::max(worst, *constraints.at_least - form.a);
    if (constraints.monotone)
      worst = std::max(worst, form.v[0] * (*constraints.monotone == Course::rises ? -1 : 1));
  }
  return worst;
}

// Nothing beside the answer that keeps the constraints has a smaller square, and the answer keeps them.
TEST(ConstrainedStudy, IsALeastSquareOfThoseThatKeepTheConstraints) {
  const Study pair = study_of("(1 - x)^5", "exp2((a x + b) x)");
  const Study step = study_of("smoothstep(0.3, 0.6, x)", "a + b x + d x^2 + g x^3");
  const Study logistic = study_of("smoothstep(0.3, 0.6, x)", "d + 1/(1 + exp(-a (x - b)))");
  const std::vector<std::pair<Study, Constraints>> fits{
      {pair, {.one_sided = Side::above}},
      {step, {.monotone = Course::rises}},
      {step, {.at_most = 1, .at_least = 0}},
      {step, {.at_most = 1, .at_least = 0, .monotone = Course::rises}},
      {logistic, {.one_sided = Side::below}},
  };
  for (const auto& [study, constraints] : fits) {
    const StudyFit fit = fit_of(study, constraints);
    ASSERT_EQ(name(fit.status), "converged") << study.form << describe(constraints) << ": " << fit.why;
    EXPECT_LT(violation(study, constraints, fit.parameters), 1e-12) << study.form << describe(constraints);
    EXPECT_FALSE(fit.alternation.empty()) << study.form << describe(constraints);
    const ReadStudy read = read_study(study);
    const StudyError error(read);
    for (unsigned i = 0; i < 100; ++i) {
      std::vector<double> beside = fit.parameters;
      for (std::size_t j = 0; j < beside.size(); ++j)
        beside[j] += 1e-3 * std::sin(1.0 + 7.3 * i + 2.1 * static_cast<double>(j * j + 1) * (i % 7 + 1));
      if (violation(study, constraints, beside) > 0) continue;
      EXPECT_GE(rms_error(read, error, beside), fit.rms_error * (1 - 1e-12))
          << study.form << describe(constraints);
    }
  }
}

// Levels of linear programmes on places that grow, and of SciPy on a fine grid. The fourth: the level is that
// of x = 1 alone, and many parameters have it.
TEST(ConstrainedStudy, HasTheLeastLevelOfALinearForm) {
  struct Known {
    Study study;
    Constraints constraints;
    double level, rounding;
    bool is_unique;
  };
  const Constraints rises{.monotone = Course::rises};
  const char* cubic = "a + b x + d x^2 + g x^3";
  const std::vector<Known> all{
      {study_of("pow(x, 6)", cubic), rises, 0.074536, 1e-6, true},
      {study_of("tanh(4 x)", cubic), rises, 0.040146, 1e-6, true},
      {study_of("tanh(4 x/1e9 - 4)", cubic, "1e9", "2e9"), rises, 0.040146, 1e-6, true},
      {study_of("exp(x)", "a + b x + d x^2"), {.at_most = 2}, std::exp(1.0) - 2, 1e-15, false},
  };
  for (const auto& [study, constraints, level, rounding, is_unique] : all) {
    const StudyFit fit = solve_minimax_study(read_study(study), constraints, {});
    ASSERT_EQ(name(fit.status), "converged") << study.target << ": " << fit.why;
    EXPECT_NEAR(*fit.level, level, rounding) << study.target;
    EXPECT_EQ(fit.is_unique, is_unique) << study.target;
    EXPECT_LT(violation(study, constraints, fit.parameters), 1e-12) << study.target;
  }
  // In the root of x this is r^3 by a + d r^2, whose errors at 0, 2/3 and 1 are the level. The slope is
  // infinite at 0.
  const Study root = study_of("x sqrt(x)", "a + b sqrt(x) + d x");
  EXPECT_NEAR(*solve_minimax_study(read_study(root), rises, {}).level, 2.0 / 27, 1e-9);
  const Study twice = study_of("exp(x)", "a x + b x");
  EXPECT_EQ(fit_of(twice, {.at_most = 0.5}).why, "the curve stays the same while a, b change together");
}

// The best quotient without the constraint is negative at 0, so that the way to the exact value crosses 0.
TEST(ConstrainedStudy, BecomesExactAcrossAChangeOfSign) {
  const Study signal = study_of("pow((3424/4096 + 2413/128*x)/(1 + 2392/128*x), 2523/32)",
                                "(a + x (b + x (d + g x)))/(h + x (l + x (m + x)))");
  EXPECT_LT(fit_of(signal, {}).parameters[0], 0);
  const StudyFit fit = fit_of(signal, {.exact_at = {0}});
  ASSERT_EQ(fit.status, Status::converged) << fit.why;
  // the signal of black in SMPTE ST 2084, (3424/4096)^(2523/32); h is the fifth by name
  EXPECT_NEAR(fit.parameters[0] / fit.parameters[4], 7.309559025783966e-07, 1e-16);
}

TEST(ConstrainedStudy, RefusesWhatCannotBe) {
  const auto refusal = [](const Study& study, const Constraints& constraints) -> std::string {
    try {
      fit_of(study, constraints);
    } catch (const UserError& error) {
      return error.what();
    }
    return "none";
  };
  // At x = 1 the target is 0, which is below every exponential.
  EXPECT_EQ(refusal(study_of("(1 - x)^5", "exp2((a x + b) x)"), {.one_sided = Side::below}),
            "the form cannot satisfy the constraints: no parameters keep the form <= target at x = 1");
  const Study line = study_of("exp(x)", "a + b x");
  EXPECT_EQ(refusal(line, {.exact_at = {0.5}}), "--exact-at '0.5' is not an end of the range of x");
  EXPECT_EQ(refusal(line, {.exact_at = {0, 1}, .at_most = 2}),
            "the form cannot satisfy the constraints: no parameters keep the form <= 2 at x = 1");
  EXPECT_EQ(refusal(study_of("exp(x)", "a x + b x^2"), {.exact_at = {0}}),
            "the form cannot satisfy the constraints: the form cannot be exact at x = 0");
  const Study plane{.target = "x y", .form = "a + b x", .over = {{"x", "0", "1"}, {"y", "0", "1"}}};
  EXPECT_EQ(refusal(plane, {.monotone = Course::rises}),
            "--monotone needs a study of one variable: this one also has 'y'");
}

}  // namespace
}  // namespace shadefit
