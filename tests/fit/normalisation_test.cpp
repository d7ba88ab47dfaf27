#include <gtest/gtest.h>

#include <cmath>

#include "approx/normalisation.hpp"
#include "fit/multiprecision.hpp"
#include "fit/normalisation_check.hpp"
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
      EXPECT_LT(check.relative_difference, 1e-12) << where;
      EXPECT_LT(check.estimated_error, 1e-12) << where;
      EXPECT_GE(check.estimated_error, check.relative_difference) << where << ": the estimate is sound";
      EXPECT_EQ(check.verdict, Verdict::confirmed) << where;
    }
  }
  EXPECT_EQ(checks, 1 + 5 * 8U);
}

// The integral in double against the constants written out again, in 50 digits.
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
  EXPECT_EQ(matched, 6);
}

TEST(Normalisation, VerdictOnBothSidesOfTheTolerance) {
  EXPECT_EQ(judge_normalisation(0, 0), Verdict::confirmed);
  EXPECT_EQ(judge_normalisation(1e-12, 1e-12), Verdict::confirmed);
  EXPECT_EQ(judge_normalisation(1.01e-12, 0), Verdict::refuted);
  EXPECT_EQ(judge_normalisation(0, 1.01e-12), std::nullopt) << "an uncertain integral says nothing";
  EXPECT_EQ(judge_normalisation(1, std::nan("")), std::nullopt);
}

}  // namespace
}  // namespace shadefit
