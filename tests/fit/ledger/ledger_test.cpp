#include "fit/ledger/ledger.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>
#include <string>

#include "fit/support/decimal.hpp"
#include "tests/fit/ledger/find_claim.hpp"

namespace shadefit {
namespace {

TEST(Ledger, IdsStandOnceAndRecordsAreComplete) {
  std::set<std::string_view> ids;
  for (const Topic& topic : ledger()) {
    for (const Claim& claim : topic.claims) {
      EXPECT_TRUE(ids.insert(claim.id).second) << claim.id << " stands twice";
      EXPECT_TRUE(has_claim(claim.id)) << claim.id;
      EXPECT_FALSE(claim.statement.empty() || claim.derivation.empty()) << claim.id;
      EXPECT_FALSE(claim.source.author.empty() || claim.source.title.empty() || claim.source.place.empty())
          << claim.id;
      EXPECT_GT(claim.source.year, 1900) << claim.id;
    }
  }
  EXPECT_FALSE(has_claim("power") || has_claim("")) << "a part of an id, and none";
}

/// "none", with a reason or without, or sentences that each give 8-bit sRGB codes, the largest absolute
/// change and where it is, the largest relative one and where that is, and ulps of a half.
bool is_in_form(const std::string& effect) {
  static const std::regex part(
      R"(.*moves .+ by up to [-+.e0-9]+ codes? of 8-bit sRGB \(absolute: [-+.e0-9]+ at [^();]*[0-9][^();]*; )"
      R"(relative: ([-+.e0-9]+ at [^();]*[0-9][^();]*|none, as no value reaches 1/255|0 for values from 1/255 on); )"
      R"(half float: [-+.e0-9]+ ulps?\))");
  if (effect == "none" || effect.starts_with("none: ")) return true;
  for (std::size_t at = 0; at < effect.size();) {
    const std::size_t end = std::min(effect.find(". ", at), effect.size());
    if (!std::regex_match(effect.substr(at, end - at), part)) return false;
    at = end + 2;
  }
  return true;
}

TEST(Ledger, EveryClaimIsJudgedWithWordsAndAnEffectInForm) {
  std::size_t with_numbers = 0;
  Fits fits;
  for (const JudgedClaim& judged : judge_claims([](std::string_view) { return true; }, fits)) {
    const auto& finding = judged.finding;
    EXPECT_TRUE(finding.verdict.has_value()) << judged.claim->id << ": " << finding.evidence;
    EXPECT_FALSE(finding.computed.empty() || finding.evidence.empty() || finding.effect.empty())
        << judged.claim->id;
    EXPECT_FALSE(finding.evidence.ends_with('.')) << judged.claim->id;
    for (const std::string* text : {&finding.computed, &finding.evidence, &finding.effect}) {
      EXPECT_EQ(text->find("nan"), std::string::npos) << judged.claim->id << ": " << *text;
      EXPECT_EQ(text->find('\n'), std::string::npos) << judged.claim->id;
    }
    EXPECT_TRUE(is_in_form(finding.effect)) << judged.claim->id << ": " << finding.effect;
    with_numbers += finding.effect.starts_with("none") ? 0 : 1;
  }
  EXPECT_GT(with_numbers, 40U) << "effects, not their absence";
}

TEST(Ledger, TheFormOfAnEffectIsChecked) {
  const std::string whole =
      "x: moves it by up to 0.3 codes of 8-bit sRGB (absolute: 1e-05 at c = 0.5; relative: 0.2 at k = 3; half "
      "float: 1 ulp)";
  EXPECT_TRUE(is_in_form(whole));
  EXPECT_TRUE(is_in_form(whole + ". " + whole));
  EXPECT_TRUE(is_in_form("none: no value changes; 1 instruction a pixel more"));
  EXPECT_FALSE(is_in_form(whole + ". The reflection is wider"));
  EXPECT_FALSE(is_in_form("none for a power above 0; outside a pixel without a value"));
  for (const std::string_view lost :
       {" at c = 0.5", " at k = 3", "relative: 0.2 ", "; half float: 1 ulp", "0.3 codes of 8-bit sRGB "}) {
    std::string changed = whole;
    changed.erase(changed.find(lost), lost.size());
    EXPECT_FALSE(is_in_form(changed)) << changed;
  }
}

TEST(Ledger, AClaimThatNothingComputesIsAnErrorOfOurs) {
  Fits fits;
  EXPECT_THROW(evaluate(Claim{.id = "sg-ofset", .statement = "", .derivation = "", .source = {}}, fits),
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

// max of c - c^2 is 1/4, at c = 1/2.
TEST(Finding, EffectOfAPower) {
  EXPECT_EQ(effect_of_power(8, 8), "none");
  const std::string effect = effect_of_power(1, 2);
  EXPECT_TRUE(
      effect.starts_with("moves the curve by up to 67 codes of 8-bit sRGB (absolute: 0.25 at c = 0.5;"))
      << effect;
}

TEST(Finding, EffectOfAFactor) {
  EXPECT_EQ(effect_of_factor(0.25, 0.25), "none");
  // A colour of 1/255 times 1.01: (12.92/255) * 0.01 * 255 = 0.1292 codes where sRGB is straight; at 1,
  // 255 * 1.055 * (1 - 0.99^(1/2.4)) for 0.99: 1.12. Both by hand.
  // In halves the grey 254/255, just below 1, is worth most: 0.01 * 254/255 / 2^-11 = 20.4.
  EXPECT_EQ(
      effect_of_factor(0.99, 1, "at k = 2 it"),
      "at k = 2 it makes a factor too small by 0.01 of its value, which moves a linear grey by up to 1.1 codes of 8-bit "
      "sRGB (absolute: 0.01 at grey 255/255; relative: 0.01 at grey 255/255; half float: 20 ulps)");
  EXPECT_NE(
      effect_of_factor(2.02, 2).find("makes a factor too large by 0.01 of its value, or by 0.02, which"),
      std::string::npos);
}

}  // namespace
}  // namespace shadefit
