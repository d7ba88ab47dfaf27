#include "fit/ledger/agreement.hpp"

#include <gtest/gtest.h>

namespace shadefit {
namespace {

TEST(Agreement, TheRulesHaveToBeGoodBeforeTheySpeak) {
  Agreement agreement;
  agreement.compare(2, {2 + 2e-9, 1e-12}, {2, 1e-12});
  EXPECT_NEAR(agreement.gap, 1e-9, 1e-15) << "relative to the closed form";
  EXPECT_EQ(agreement.verdict(1e-8), Verdict::confirmed);
  EXPECT_EQ(agreement.verdict(1e-10), std::nullopt) << "the two rules are further apart than that";
  Agreement wrong;
  wrong.compare(2, {2.5, 1e-12}, {2.5, 1e-12});
  EXPECT_EQ(wrong.verdict(1e-10), Verdict::refuted);
  wrong.compare(2, {2, 1e-3}, {2, 1e-12});
  EXPECT_EQ(wrong.verdict(1e-10), std::nullopt) << "and one weak comparison is enough";
}

TEST(Agreement, BelowTheToleranceABoundIsSaid) {
  EXPECT_EQ(within(3.3e-16, "1e-12"), "within 1e-12");
  EXPECT_EQ(within(0.0123, "1e-12"), "to 0.012");
}

// max of c - c^2 is 1/4, at c = 1/2.
TEST(Agreement, EffectOfAPower) {
  EXPECT_EQ(effect_of_power(8, 8), "none");
  EXPECT_EQ(effect_of_power(1, 2).find(
                "moves the curve by up to 67 codes of 8-bit sRGB (absolute: 0.25 at c = 0.5;"),
            0U)
      << effect_of_power(1, 2);
}

}  // namespace
}  // namespace shadefit
