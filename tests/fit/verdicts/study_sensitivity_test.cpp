#include "fit/verdicts/study_sensitivity.hpp"

#include <gtest/gtest.h>

#include <string>

#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

const Study fresnel{.target = "(1 - c)^5", .form = "exp2((a c + b) c)", .over = {{"c", "0", "1"}}};

StudySensitivity sensitivity(const Study& study, Norm norm, const Constraints& constraints = {}) {
  const StudyObjective objective = objective_of(study, norm, constraints);
  return sensitivity_of(objective, fit_study(objective));
}

// Text and family: the same digits, intervals and other fits.
TEST(StudySensitivity, IsThatOfTheFamily) {
  for (const Norm norm : {Norm::least_squares, Norm::minimax}) {
    const auto [constants, others] = sensitivity(fresnel, norm);
    const Sensitivity expected =
        sensitivity_of(find_family("fresnel-quadratic")->fit({}, Metric{.norm = norm}));
    EXPECT_NEAR(constants.objective / expected.objective, 1, 1e-9);
    ASSERT_EQ(constants.parameters.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
      const ParameterSensitivity &found = constants.parameters[i], &known = expected.parameters[i];
      EXPECT_EQ(found.parameter, known.parameter);
      EXPECT_EQ(found.noticeable_digits, known.noticeable_digits);
      EXPECT_EQ(found.slight_digits, known.slight_digits);
      EXPECT_NEAR(found.lower.value() / known.lower.value(), 1, 1e-6);
      EXPECT_NEAR(found.upper.value() / known.upper.value(), 1, 1e-6);
    }
    EXPECT_EQ(constants.noticeable_digits->parameters, expected.noticeable_digits->parameters);
    EXPECT_EQ(constants.slight_digits->parameters, expected.slight_digits->parameters);
    ASSERT_EQ(others.size(), expected.contracts.size());
    for (std::size_t i = 0; i < others.size(); ++i)
      EXPECT_NEAR(others[i].fit.parameters[0] / expected.contracts[i].fit.parameters[0], 1, 1e-12)
          << others[i].under;
  }
}

// |a| is the error at 0, so the held a alone makes the largest error: b is free there.
TEST(StudySensitivity, HasAnEndWhereAHeldConstantMakesTheError) {
  const Study line{.target = "x^2", .form = "a + b x", .over = {{"x", "0", "1"}}};
  const auto found = sensitivity(line, Norm::minimax).constants;
  EXPECT_NEAR(found.objective, 0.125, 1e-12);
  EXPECT_NEAR(found.parameters[0].lower.value(), -0.125 * 1.01, 1e-9);
  EXPECT_GT(found.parameters[0].upper.value(), -0.125);
}

TEST(StudySensitivity, RefusesConstraintsAndRows) {
  EXPECT_THROW(sensitivity(fresnel, Norm::minimax, {.exact_at = {0}}), UserError);
  const auto two_variables = sensitivity(
      {.target = "x y", .form = "a + b x", .over = {{"x", "0", "1"}, {"y", "0", "1"}}}, Norm::least_squares);
  EXPECT_EQ(two_variables.constants.parameters.size(), 2U);
  EXPECT_TRUE(two_variables.others.empty());
}

}  // namespace
}  // namespace shadefit
