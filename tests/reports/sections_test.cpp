#include <gtest/gtest.h>

#include "fit/better/results.hpp"
#include "reports/io/csv.hpp"
#include "reports/io/writers.hpp"
#include "reports/sections/ledger_section.hpp"
#include "reports/sections/prose.hpp"
#include "reports/sections/sections.hpp"
#include "tests/refusal.hpp"

namespace shadefit {
namespace {

using testing::expect_has;
using testing::expect_lacks;

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
  expect_has(section, "### Topic\n\n| claim ");
  expect_has(
      section,
      "- **`x-claim`** (Author 2012): a is b.\n  - **rounding**: it is 1.6.\n  - Effect: 0.1 codes.\n");
}

TEST(LedgerSection, LinksAFigureThatIsDrawn) {
  const auto with = [](const char* name) {
    Figure figure{};
    figure.name = name;
    return ledger_section({judged}, {figure});
  };
  expect_has(with("offset"), "Plot: [offset](plots/offset.svg).\n");
  expect_lacks(with("lobe"), "plots/");
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
  expect_has(text, "\n          word word");
}

TEST(Explanation, StartsALineWithEachSentence) {
  JudgedClaim two = judged;
  two.finding.evidence = "over c = 0 .. 1 it is 1.6. The rest is 2";
  expect_has(explanation(two), "evidence  over c = 0 .. 1 it is 1.6.\n          The rest is 2\n");
}

JudgedClaim news_with(Verdict verdict) {
  return {&topic, &claim, {verdict, "1.6", "it is 1.6. The rest is 2", "by 3 codes. Elsewhere none"}};
}

TEST(News, RefutedClaimsComeFirstAndConfirmedOnesNotAtAll) {
  EXPECT_EQ(
      news_section(
          {news_with(Verdict::conditional), news_with(Verdict::confirmed), news_with(Verdict::refuted)}),
      "## News\n\nWe judged 3 claims: 1 confirmed, 1 conditional, 1 refuted. [How to read it](#how-to-read-it) "
      "explains the words.\n\n"
      "**Refuted:**\n\n"
      "- [`x-claim`](#topic) (Author 2012): a is b.\n"
      "  - Found: it is 1.6. The rest is 2.\n  - Effect: by 3 codes.\n\n"
      "**Conditional:** true only for a part of the range, or only in one interpretation of the words:\n\n"
      "- [`x-claim`](#topic) (Author 2012): a is b.\n"
      "  - Found: 1.6.\n  - Effect: by 3 codes.\n\n");
}

TEST(News, NoneIsSaidInOneLine) {
  EXPECT_EQ(
      news_section({news_with(Verdict::confirmed)}),
      "## News\n\nWe judged 1 claim: 1 confirmed. [How to read it](#how-to-read-it) explains the words.\n\n");
}

TEST(Prose, AFullStopAndASpaceEndASentence) {
  EXPECT_EQ(sentences_of("k is 1.5. c is 0 .. 1. The end."),
            (std::vector<std::string>{"k is 1.5.", "c is 0 .. 1.", "The end."}));
  EXPECT_EQ(sentences_of(""), std::vector<std::string>{""});
}

TEST(Prose, LinesOfAListKeepTheirIndentation) {
  EXPECT_EQ(with_short_lines("One. Two.\n\n- A. B.\n  - C. D.\n"),
            "One.\nTwo.\n\n- A.\n  B.\n  - C.\n    D.\n");
}

TEST(Prose, TablesHeadingsAndPicturesStay) {
  const std::string text = "## A. B\n| a. b |\n![a. b](c)\n";
  EXPECT_EQ(with_short_lines(text), text);
}

TEST(Prose, ALongSentenceIsBrokenAtItsSemicolonsOrColons) {
  const std::string half(250, 'x');
  EXPECT_EQ(with_short_lines(half + "; " + half + "."), half + ";\n" + half + ".\n");
  EXPECT_EQ(with_short_lines("- a: " + half + ": " + half + "."), "- a:\n  " + half + ":\n  " + half + ".\n");
  EXPECT_EQ(with_short_lines("a: b; " + half + half + "."), "a: b;\n" + half + half + ".\n");
  EXPECT_EQ(with_short_lines("a; b: c."), "a; b: c.\n");
}

TEST(Prose, AnAnchorIsThatOfGitHub) {
  EXPECT_EQ(anchor("Spherical Gaussian offset (`sg-offset`)"), "spherical-gaussian-offset-sg-offset");
  EXPECT_EQ(anchor("(1 - c)^5"), "1---c5");
}

TEST(Prose, ContentsListTheHeadingsOfTwoLevels) {
  EXPECT_EQ(contents("# Title\n## First\ntext\n### Inner\n#### Deep\n"),
            "- [First](#first)\n  - [Inner](#inner)\n\n");
}

std::vector<ReflectanceCurve> curves_of(std::string_view wanted) {
  return reflectance_curves([&](std::string_view id) { return id == wanted; });
}

TEST(ReflectanceTable, HasTheColumnsThatOthersRelyOn) {
  EXPECT_EQ(write_csv(reflectance_table({}), Precision::report),
            "constant,exponent,view_angle,reflectance,estimated_error,with_cosine\n");
  const auto csv =
      parse_csv(write_csv(reflectance_table(curves_of("norm-phong")), Precision::report), "reflectance");
  ASSERT_EQ(csv.rows.size(), 44U);
  EXPECT_EQ(csv.rows[0], (std::vector<std::string>{"norm-phong", "1", "0", "1", "1e-10", "0.6666666667"}));
  EXPECT_EQ(csv.rows[4],
            (std::vector<std::string>{"norm-phong", "1", "60", "0.75", "1e-10", "0.4059985207"}));
}

TEST(ReflectanceTable, ShowsAnErrorThatBreaksThePromise) {
  Results results;
  results.reflectances = curves_of("norm-phong-brdf");
  EXPECT_TRUE(all_checks_passed(results));
  results.reflectances[1].points[2].estimated_error = 2.34e-10;
  EXPECT_FALSE(all_checks_passed(results));
  const auto csv =
      parse_csv(write_csv(reflectance_table(results.reflectances), Precision::report), "reflectance");
  EXPECT_EQ(csv.rows[11 + 2][4], "2.3e-10");
  EXPECT_EQ(csv.rows[11 + 3][4], "1e-10");
}

TEST(ReflectanceSection, SaysWhoCreatesEnergyAndWhere) {
  const auto cheap = reflectance_section(curves_of("norm-blinn-phong-cheap"));
  expect_has(cheap,
             "- `norm-blinn-phong-cheap` creates energy: below 21.71 degrees for a = 1, below 18.1 "
             "degrees for a = 8, below 9.437 degrees for a = 64, below 1.786 degrees for a = 2048. "
             "Its reflectance is largest, 1.075 at 0 degrees for a = 8.\n");
  const auto exact = reflectance_section(curves_of("norm-blinn-phong-brdf"));
  EXPECT_NE(
      exact.find(
          "- `norm-blinn-phong-brdf` creates no energy for a = 1, 8, 64, 2048: its reflectance with n.l is at most 1 at 0 "
          "degrees for a = 1, 8, 64, 2048.\n"),
      std::string::npos)
      << "equal peaks are named together, not picked by rounding\n"
      << exact;
  EXPECT_EQ(exact.find("times n.l, `"), std::string::npos) << "its lobe has n.l already";
  expect_has(reflectance_section(curves_of("norm-phong")), "times n.l, `");
}

}  // namespace
}  // namespace shadefit
