#include <gtest/gtest.h>

#include <cmath>

#include "approx/normalisation.hpp"
#include "fit/claims/normalisation_check.hpp"
#include "fit/scalars/multiprecision.hpp"
#include "tests/accuracy.hpp"

namespace shadefit {
namespace {

using testing::is_close;

TEST(Normalisation, EveryConstantIsConfirmedAtEveryExponent) {
  std::size_t checks = 0;
  for (const Normalisation& record : normalisations) {
    for (const auto& check : check_normalisation(record)) {
      ++checks;
      const auto where = std::string(record.id) + " " + std::to_string(check.exponent.value_or(0));
      EXPECT_LT(check.estimated_error, 1e-12) << where;
      if (record.closeness == 0) {
        EXPECT_LT(check.relative_difference, 1e-12) << where;
        EXPECT_GE(check.estimated_error, check.relative_difference) << where << ": the estimate is sound";
      }
      EXPECT_EQ(check.verdict, Verdict::confirmed) << where;
    }
  }
  EXPECT_EQ(checks, 1 + 7 * 8U);
}

// The integral in double against independent formulas of the constants in 50 digits.
TEST(Normalisation, IntegralsAreRightToTwelveDigits) {
  int matched = 0;
  const auto check = [&](std::string_view id, auto constant) {
    for (const Normalisation& record : normalisations) {
      if (record.id != id) continue;
      ++matched;
      for (const auto& c : check_normalisation(record)) {
        EXPECT_TRUE(
            is_close(std::string(id), constant(Decimal50(c.exponent.value_or(1))), c.integral, 1e-13));
      }
    }
  };
  const Decimal50 p = pi<Decimal50>();
  check("norm-lambert", [&](const Decimal50&) { return 1 / p; });
  check("norm-phong", [&](const Decimal50& a) { return (a + 1) / (2 * p); });
  check("norm-phong-brdf", [&](const Decimal50& a) { return (a + 2) / (2 * p); });
  check("norm-blinn-phong",
        [&](const Decimal50& a) { return (a + 2) / (4 * p * (2 - pow(Decimal50(2), -a / 2))); });
  check("norm-blinn-phong-brdf",
        [&](const Decimal50& a) { return (a + 2) * (a + 4) / (8 * p * (pow(Decimal50(2), -a / 2) + a)); });
  check("norm-ndf", [&](const Decimal50& a) { return (a + 2) / (2 * p); });
  check("norm-blinn-phong-cheap",  // its integral is that of the exact constant
        [&](const Decimal50& a) { return (a + 2) * (a + 4) / (8 * p * (pow(Decimal50(2), -a / 2) + a)); });
  check("norm-microfacet", [&](const Decimal50& a) { return (a + 2) / (8 * p); });
  EXPECT_EQ(matched, 8);
}

TEST(Normalisation, VerdictOnBothSidesOfTheTolerance) {
  EXPECT_EQ(judge_normalisation(0, 0), Verdict::confirmed);
  EXPECT_EQ(judge_normalisation(1e-12, 1e-12), Verdict::confirmed);
  EXPECT_EQ(judge_normalisation(1.01e-12, 0), Verdict::refuted);
  EXPECT_EQ(judge_normalisation(0, 1.01e-12), std::nullopt) << "an uncertain integral says nothing";
  EXPECT_EQ(judge_normalisation(1, std::nan("")), std::nullopt);
  EXPECT_EQ(judge_normalisation(0.1, 1e-12, 0.1), Verdict::confirmed) << "a stand-in, as close as it says";
  EXPECT_EQ(judge_normalisation(0.1001, 1e-12, 0.1), Verdict::refuted);
  EXPECT_EQ(judge_normalisation(0, 1.01e-12, 0.1), std::nullopt);
}

// (a+8)(2^(-a/2)+a) / ((a+2)(a+4)), independent of approx/.
Decimal50 cheap_over_exact(const Decimal50& a) {
  return (a + 8) * (pow(Decimal50(2), -a / 2) + a) / ((a + 2) * (a + 4));
}

TEST(Normalisation, TheCheapConstantIsTheRatioItSays) {
  for (const auto& check : check_normalisation(BlinnPhongCheapLobe::record)) {
    const Decimal50 ratio = cheap_over_exact(Decimal50(*check.exponent));
    EXPECT_TRUE(is_close("ratio", ratio, check.closed_form / check.integral, 1e-14));
    // its own rounding is 1e-15 of the ratio, not of the difference to 1
    EXPECT_NEAR(check.relative_difference, Decimal50(ratio - 1).convert_to<double>(), 1e-14);
  }
}

TEST(Normalisation, TheCheapConstantIsFurthestOffNearNine) {
  const auto [exponent, ratio] = largest_cheap_ratio();
  const Decimal50 a(exponent), step("1e-20");
  EXPECT_TRUE(is_close("largest", cheap_over_exact(a), ratio, 1e-15));
  // the slope by central differences of 50 digits changes its sign within 1e-10 of the place
  const auto slope = [&](const Decimal50& at) {
    return Decimal50(cheap_over_exact(at + step) - cheap_over_exact(at - step));
  };
  EXPECT_GT(slope(a - 1e-10), 0);
  EXPECT_LT(slope(a + 1e-10), 0);
  for (double other = 1e-3; other < 1e6; other *= 1.01) EXPECT_LE(cheap_over_exact(other), ratio) << other;
  EXPECT_NEAR(exponent, 8.76, 0.005);
  EXPECT_NEAR(ratio, 1.075, 0.0005);
}

}  // namespace
}  // namespace shadefit
