#include "reports/sections/ledger_section.hpp"

#include <gtest/gtest.h>

#include "fit/better/results.hpp"
#include "reports/io/csv.hpp"
#include "reports/table/writers.hpp"

namespace shadefit {
namespace {

const Claim claim{.id = "x-claim",
                  .statement = "a is b",
                  .printed = {{"a", "1.5"}, {"", "2"}},
                  .inputs = {{"k", "5"}},
                  .derivation = "because",
                  .figure = "offset",
                  .source = {"Author", 2012, "Title", "Place"}};
const Topic topic{"Topic", std::span(&claim, 1)};
const JudgedClaim judged{&topic, &claim, {Verdict::rounding, "1.6", "it is 1.6", "0.1 codes"}};

TEST(ClaimsTable, HasTheColumnsThatOthersRelyOn) {
  EXPECT_EQ(
      write_csv(claims_table({judged}), Precision::report),
      "claim,printed,computed,verdict,effect,evidence,source,topic,statement\n"
      "x-claim,\"a = 1.5, 2\",1.6,rounding,0.1 codes,it is 1.6,\"Author 2012, Title, Place\",Topic,a is b\n");
}

TEST(ClaimsTable, WeakEvidenceIsNoVerdictAndFailsTheRun) {
  JudgedClaim weak = judged;
  weak.finding.verdict = std::nullopt;
  EXPECT_EQ(verdict_text(weak.finding), "not-converged");
  EXPECT_EQ(verdict_counts({judged, weak}), "2 claims: 1 rounding, 1 not-converged");
  Results results;
  results.claims = {judged};
  EXPECT_TRUE(all_checks_passed(results));
  results.claims.push_back(weak);
  EXPECT_FALSE(all_checks_passed(results));
}

TEST(LedgerSection, HasASectionForEachTopic) {
  const std::string section = ledger_section({judged}, {});
  EXPECT_NE(section.find("### Topic\n\n| claim "), std::string::npos) << section;
  EXPECT_NE(
      section.find(
          "- **`x-claim`** (Author 2012): a is b.\n  - **rounding**: it is 1.6.\n  - Effect: 0.1 codes.\n"),
      std::string::npos)
      << section;
}

TEST(LedgerSection, LinksAFigureThatIsDrawn) {
  const auto with = [](const char* name) {
    Figure figure{};
    figure.name = name;
    return ledger_section({judged}, {figure});
  };
  EXPECT_NE(with("offset").find("Plot: [offset](plots/offset.svg).\n"), std::string::npos);
  EXPECT_EQ(with("lobe").find("plots/"), std::string::npos);
}

TEST(Explanation, HasEveryPartOnceAndWrapsLongLines) {
  EXPECT_EQ(explanation(judged),
            "x-claim\n"
            "topic     Topic\n"
            "says      a is b\n"
            "printed   a = 1.5, 2\n"
            "source    Author 2012, Title, Place\n"
            "given     k = 5\n"
            "why       because\n"
            "computed  1.6\n"
            "verdict   rounding\n"
            "evidence  it is 1.6\n"
            "effect    0.1 codes\n"
            "plot      plots/offset.svg\n");
  JudgedClaim wordy = judged;
  wordy.finding.evidence.clear();
  for (int i = 0; i < 40; ++i) wordy.finding.evidence += "word ";
  std::size_t longest = 0, start = 0;
  const std::string text = explanation(wordy);
  for (std::size_t end; (end = text.find('\n', start)) != std::string::npos; start = end + 1)
    longest = std::max(longest, end - start);
  EXPECT_LE(longest, 106U);
  EXPECT_NE(text.find("\n          word word"), std::string::npos);
}

TEST(Explanation, StartsALineWithEachSentence) {
  JudgedClaim two = judged;
  two.finding.evidence = "over c = 0 .. 1 it is 1.6. The rest is 2";
  EXPECT_NE(explanation(two).find("evidence  over c = 0 .. 1 it is 1.6.\n          The rest is 2\n"),
            std::string::npos)
      << explanation(two);
}

}  // namespace
}  // namespace shadefit
