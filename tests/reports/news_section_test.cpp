#include "reports/sections/sections.hpp"

#include <gtest/gtest.h>

namespace shadefit {
namespace {

const Claim news_claim{.id = "x-claim",
                       .statement = "a is b",
                       .derivation = "because",
                       .source = {"Author", 2012, "Title", "Place"}};
const Topic news_topic{"First topic", std::span(&news_claim, 1)};

JudgedClaim news_with(Verdict verdict) {
  return {
      &news_topic, &news_claim, {verdict, "1.6", "it is 1.6. The rest is 2", "by 3 codes. Elsewhere none"}};
}

TEST(News, RefutedClaimsComeFirstAndConfirmedOnesNotAtAll) {
  EXPECT_EQ(
      news_section(
          {news_with(Verdict::conditional), news_with(Verdict::confirmed), news_with(Verdict::refuted)}),
      "## News\n\nWe judged 3 claims: 1 confirmed, 1 conditional, 1 refuted. [How to read it](#how-to-read-it) "
      "explains the words.\n\n"
      "**Refuted:**\n\n"
      "- [`x-claim`](#first-topic) (Author 2012): a is b.\n"
      "  - Found: it is 1.6. The rest is 2.\n  - Effect: by 3 codes.\n\n"
      "**Conditional:** true only for a part of the range, or only in one interpretation of the words:\n\n"
      "- [`x-claim`](#first-topic) (Author 2012): a is b.\n"
      "  - Found: 1.6.\n  - Effect: by 3 codes.\n\n");
}

TEST(News, NoneIsSaidInOneLine) {
  EXPECT_EQ(
      news_section({news_with(Verdict::confirmed)}),
      "## News\n\nWe judged 1 claim: 1 confirmed. [How to read it](#how-to-read-it) explains the words.\n\n");
}

}  // namespace
}  // namespace shadefit
