#include "fit/ledger.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "approx/ledger.hpp"
#include "fit/decimal.hpp"

namespace shadefit {
namespace {

TEST(Ledger, IdsStandOnceAndRecordsAreComplete) {
  std::set<std::string_view> ids;
  for (const Topic& topic : ledger) {
    for (const Claim& claim : topic.claims) {
      EXPECT_TRUE(ids.insert(claim.id).second) << claim.id << " stands twice";
      EXPECT_FALSE(claim.statement.empty() || claim.derivation.empty()) << claim.id;
      EXPECT_FALSE(claim.source.author.empty() || claim.source.title.empty() || claim.source.place.empty())
          << claim.id;
      EXPECT_GT(claim.source.year, 1900) << claim.id;
    }
  }
}

TEST(Ledger, EveryClaimIsJudgedWithWords) {
  for (const JudgedClaim& judged : judge_claims([](std::string_view) { return true; })) {
    const auto& finding = judged.finding;
    EXPECT_TRUE(finding.verdict.has_value()) << judged.claim->id << ": " << finding.evidence;
    EXPECT_FALSE(finding.computed.empty() || finding.evidence.empty() || finding.effect.empty())
        << judged.claim->id;
    EXPECT_FALSE(finding.evidence.ends_with('.')) << judged.claim->id;
    for (const std::string* text : {&finding.computed, &finding.evidence, &finding.effect}) {
      EXPECT_EQ(text->find("nan"), std::string::npos) << judged.claim->id << ": " << *text;
      EXPECT_TRUE(std::none_of(text->begin(), text->end(), [](char c) { return c == '\n'; }))
          << judged.claim->id;
    }
  }
}

TEST(Ledger, AClaimThatNothingComputesIsAnErrorOfOurs) {
  EXPECT_THROW(evaluate(Claim{.id = "sg-ofset", .statement = "", .derivation = "", .source = {}}),
               std::logic_error);
  EXPECT_EQ(find_claim("sg-ofset"), nullptr);
}

TEST(Finding, TheWorstPartDecides) {
  using enum Verdict;
  const std::optional<Verdict> mixed[] = {confirmed, conditional, rounding};
  EXPECT_EQ(worst(std::span(mixed)), conditional);
  const std::optional<Verdict> weak[] = {refuted, std::nullopt};
  EXPECT_EQ(worst(std::span(weak)), std::nullopt);
  const Verdict sure[] = {confirmed, refuted, other_objective};
  EXPECT_EQ(worst(std::span(sure)), refuted);
}

TEST(Finding, EvidenceWeakerThanThePrintedDigitsDecidesNothing) {
  EXPECT_EQ(judge_known_to("0.775", 0.7753, 1e-4), Verdict::confirmed);
  EXPECT_EQ(judge_known_to("0.775", 0.7753, 3e-4), std::nullopt);  // up to 0.7756: 0.776
  EXPECT_EQ(judge_known_to("0.775", 0.9, 1e-3), Verdict::refuted);
}

TEST(Finding, EffectOfAFactor) {
  EXPECT_EQ(effect_of_factor(0.25, 0.25), "none");
  // A colour of 1/255 times 1.01: (12.92/255) * 0.01 * 255 = 0.1292 codes where sRGB is straight; at 1,
  // 255 * 1.055 * (1 - 0.99^(1/2.4)) for 0.99: 1.12. Both by hand.
  EXPECT_NE(effect_of_factor(0.99, 1).find("1 - 0.01: at most 1.1 8-bit sRGB codes"), std::string::npos)
      << effect_of_factor(0.99, 1);
}

TEST(Decimal, SaysAsManyDigitsAsAreMeant) {
  EXPECT_EQ(decimal(0.775, 10), "0.775");
  EXPECT_EQ(decimal(-0.0, 3), "0");
  EXPECT_EQ(decimal(1.25e-7, 2), "1.2e-07");
  EXPECT_EQ(decimal(2048, 6), "2048");
  EXPECT_EQ(counted(1, "step"), "1 step");
  EXPECT_EQ(counted(2, "step"), "2 steps");
  EXPECT_EQ(enumerated(std::array{"a", "b", "c"}), "a, b and c");
  EXPECT_EQ(enumerated(std::array{"a"}), "a");
}

}  // namespace
}  // namespace shadefit
