#include "fit/quadrature/rule_choice.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

#include "fit/families/families.hpp"
#include "fit/least_squares/least_squares.hpp"

namespace shadefit {
namespace {

// If the expected rule had not converged, a second rule would be used, and its step counted: the choice saves
// its time. Sums and steps are those of the fit itself, in long double at its answer.
TEST(RuleChoice, TheFirstRuleSettlesLobes) {
  const auto leaves = [](const auto& family, const Metric& metric) {
    const auto optimum = solve_least_squares(family, metric);
    const auto panels = Substitution::panels(metric, family.shape());
    const unsigned size = fit_rules[first_rule(metric, family.shape())];
    const SampledProblem<std::remove_cvref_t<decltype(family)>, long double> problem(family, panels, size);
    const auto d = problem.derivatives({static_cast<long double>(optimum.parameters[0])});
    return static_cast<double>(std::abs(d.gradient[0] / d.hessian(0, 0)) / optimum.parameters[0]);
  };
  for (const Measure measure : measures) {
    for (int k = 1; k <= 64; ++k) {
      EXPECT_LT(leaves(SgOffset{{static_cast<double>(k)}}, {.measure = measure}), settled)
          << k << " " << name(measure);
      EXPECT_LT(leaves(PhongBlinn{{static_cast<double>(k)}}, {.measure = measure}), settled) << k;
    }
    for (const double k : {100.0, 1e3, 1e4, 1e6}) {
      EXPECT_LT(leaves(SgOffset{{k}}, {.measure = measure}), settled) << k;
      EXPECT_LT(leaves(PhongBlinn{{k}}, {.measure = measure}), settled) << k;
    }
  }
}

TEST(RuleChoice, GrowsWithTheDeclineAndKnowsItsLimits) {
  const auto size = [](const Metric& metric, const Shape& shape) {
    return fit_rules[first_rule(metric, shape)];
  };
  const Metric angle{.measure = Measure::angle};
  EXPECT_EQ(size({}, {.concentration = 6, .end_power = 3}), 14U);
  EXPECT_EQ(size({}, {.concentration = 20, .end_power = 10}), 18U);
  EXPECT_EQ(size({}, {.concentration = 22, .end_power = 11}), 22U);
  EXPECT_EQ(size({}, {.concentration = 40, .end_power = 20}), 26U);
  EXPECT_EQ(size({}, {.concentration = 2e6, .end_power = 1e6}), 26U) << "cut";
  EXPECT_EQ(size(angle, {.concentration = 6, .end_power = 3}), 22U);
  EXPECT_EQ(size(angle, {.concentration = 2e6, .end_power = 1e6}), 30U);
  EXPECT_EQ(size({.domain = {0.5, 1}}, {.concentration = 20, .end_power = 10}), 14U) << "half the decline";
  EXPECT_EQ(size({}, {.concentration = 5, .end_power = 2.5}), 26U) << "singular at c = 0";
  EXPECT_EQ(size({}, {.concentration = 101, .end_power = 50.5}), 26U) << "which is cut off";
  EXPECT_EQ(size({}, {}), 26U) << "of unknown shape";
  EXPECT_EQ(size({}, {.concentration = 6, .end_power = 3, .joint = Shape::Joint{0.5}}), 26U);
}

// A wrong expectation only costs time: the exponential is steeper than the shape says, the first rule's step
// is too large, and a larger one settles the fit all the same.
struct Understated : SgOffset {
  Shape shape() const { return {.concentration = 1, .end_power = exponent}; }
};

TEST(RuleChoice, AWrongExpectationIsCaught) {
  const Understated family{{{12}}};
  ASSERT_EQ(fit_rules[first_rule({}, family.shape())], 14U);
  const auto optimum = solve_least_squares(family, Metric{});
  const auto expected = solve_least_squares(SgOffset{{12}}, Metric{});
  EXPECT_EQ(optimum.status, Status::converged);
  EXPECT_EQ(optimum.digits, 14);
  // Fourteen digits are promised.
  EXPECT_NEAR(optimum.parameters[0] / expected.parameters[0], 1, 1e-14);
}

}  // namespace
}  // namespace shadefit
