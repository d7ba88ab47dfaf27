#include "fit/proof/stationary.hpp"

#include <gtest/gtest.h>

#include <string>

#include "fit/fit.hpp"
#include "fit/scalars/multiprecision.hpp"
#include "tests/references.hpp"

namespace shadefit {
namespace {

Fit fit_under(const char* id, const Setting& setting, const Metric& metric) {
  return find_family(id)->fit(setting, metric);
}

void expect_proven(const Fit& fit) {
  const StationaryPoint point = prove_stationary(fit);
  const std::string which = std::string(fit.family->id) + " " + describe(fit.metric);
  ASSERT_TRUE(point.is_proven) << which << ": " << point.reason;
  EXPECT_TRUE(point.is_minimum) << which;
  // A fit claims 14 digits. The forms that only compare have correlated parameters (four in fresnel-quartic),
  // and the enclosure of an integral costs the proof one digit.
  EXPECT_GE(point.digits, fit.family->is_comparison ? 13 : 14) << which;
  for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
    const auto [lower, upper] = point.lies_in[i];
    EXPECT_LT(point.unique_in[i].first, lower);
    EXPECT_GT(point.unique_in[i].second, upper);
    EXPECT_LE(lower, upper);
  }
}

TEST(StationaryPoint, EveryFamilyUnderEveryMeasure) {
  for (const Measure measure : measures) {
    for (const FittableFamily& family : fittable_families()) {
      if (family.has_exponent()) {
        for (const double k : {5.0, 1e6}) expect_proven(family.fit(Setting(k), {.measure = measure}));
      } else {
        expect_proven(family.fit(Setting(), {.measure = measure}));
      }
    }
  }
}

TEST(StationaryPoint, PowersThatAreNotWholeAndPartsOfTheDomain) {
  expect_proven(fit_under("sg-offset", 0.5, {}));
  expect_proven(fit_under("sg-offset", 2.5, {.measure = Measure::angle}));
  expect_proven(fit_under("phong-blinn", 7.3, {.domain = {0.25, 1}}));
  expect_proven(fit_under("fresnel-quadratic", Setting(), {.domain = {0.125, 0.375}}));
  expect_proven(fit_under("fresnel-one-term", Setting(0, exact_surface(1.5)), {}));
}

/// The fifty digits of the references, which other methods computed, lie where the optimum is proven to lie.
TEST(StationaryPoint, TheReferencesLieWhereItIsProven) {
  int compared = 0;
  for (const auto& reference : testing::read_references()) {
    // A few exponents: each proof takes a tenth of a second.
    if (reference.exponent && *reference.exponent != 1 && *reference.exponent != 5 &&
        *reference.exponent != 1000)
      continue;
    const FittableFamily* family = find_family(reference.constant);
    if (family == nullptr) continue;
    const Fit fit = family->fit(Setting(reference.exponent.value_or(0)), reference.metric());
    const StationaryPoint point = prove_stationary(fit);
    ASSERT_TRUE(point.is_proven) << reference.describe() << ": " << point.reason;
    const auto [lower, upper] = point.lies_in[parameter_index(*family, reference.parameter)];
    EXPECT_LE(Decimal50(lower), reference.value) << reference.describe();
    EXPECT_GE(Decimal50(upper), reference.value) << reference.describe();
    ++compared;
  }
  EXPECT_GE(compared, 15);
}

TEST(StationaryPoint, WhatIsNoOptimumIsNotProven) {
  Fit fit = fit_under("fresnel-quadratic", Setting(), {});
  fit.parameters[1] *= 1 + 1e-12;
  EXPECT_EQ(prove_stationary(fit).reason, "Krawczyk's operator does not map the box into itself");
  fit = fit_under("sg-offset", 5, {});
  fit.parameters[0] *= 1 - 2e-13;
  EXPECT_FALSE(prove_stationary(fit).is_proven);
  fit.status = Status::ambiguous;
  EXPECT_EQ(prove_stationary(fit).reason, "the fit did not converge");
}

}  // namespace
}  // namespace shadefit
