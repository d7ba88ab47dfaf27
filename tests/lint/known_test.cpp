#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "fit/ledger/ledger.hpp"
#include "lint/lint_tree.hpp"
#include "lint/scan/characters.hpp"
#include "tests/lint/all_known.hpp"

/// Which constants lint knows.
namespace shadefit::lint {
namespace {

/// "id grade: PUBLISHED is FOUND" of each site; of the numbers, only those that are not right.
std::vector<std::string> faults_in(const std::string& text) {
  std::vector<std::string> words;
  for (const LintedSite& site : lint_text(text)) {
    words.push_back(site.id + " " + std::string(name(site.grade)));
    for (const LintedNumber& number : site.numbers)
      if (number.grade != Grade::right) words.back() += ": " + number.published + " is " + number.text;
  }
  return words;
}

bool is_decimal(std::string_view text) {
  return text.find('.') != std::string_view::npos &&
         text.find_first_not_of("-.0123456789") == std::string_view::npos;
}

TEST(LintKnown, TheRecordsWithManyDigits) {
  constexpr std::size_t many = 4;
  std::set<std::string> known;
  for (const KnownSet& set : known_here().sets)
    for (const KnownConstant& constant : set.constants) known.insert(digits_of(constant.printed).text);
  std::vector<std::string> unknown;
  std::size_t records = 0;
  for (const Topic& topic : ledger()) {
    for (const Claim& claim : topic.claims) {
      for (const Quantity& printed : claim.printed) {
        if (!is_decimal(printed.value) || digits_of(printed.value).text.size() < many) continue;
        ++records;
        if (known.count(digits_of(printed.value).text) == 0) unknown.emplace_back(claim.id);
      }
    }
  }
  EXPECT_GE(records, 8u);
  // The sum of two constants, which stands in a text and not in programs.
  EXPECT_EQ(unknown, Words{"fresnel-exponent-sum"});
}

TEST(LintKnown, ABasisHasOneNumberSeveralTimes) {
  const auto basis = [](const std::string& y) {
    return faults_in("vec4 f(vec3 n) { return vec4(0.282095, -" + y +
                     " * n.y, 0.488603 * n.z, -0.488603 * n.x); }");
  };
  EXPECT_EQ(basis("0.488603"), Words{"sh-basis right"});
  EXPECT_EQ(basis("0.48860251"), Words{"sh-basis right"});
  EXPECT_EQ(basis("0.486803"), Words{"sh-basis wrong: 0.488603 is 0.486803"});
  EXPECT_EQ(faults_in("float a = 0.488603;"), Words{});
}

TEST(LintKnown, TheNumbersOfTheGloss) {
  EXPECT_EQ(faults_in("float f(float g) { return exp2(10.0 * g + 1.528766); }"),
            Words{"gloss-log2-constant right"});
  EXPECT_EQ(faults_in("float f(float g) { return exp2(10.0 * g + 1.582766); }"),
            Words{"gloss-log2-constant wrong: 1.528766 is 1.582766"});
  EXPECT_EQ(faults_in("float f(float m) { return m * 0.08664 + 0.25; }"), Words{"gloss-ln2-over-8 right"});
  EXPECT_EQ(faults_in("float a = 1.528766; float b = 0.08664;"), Words{});
}

TEST(LintKnown, ANumberInTheTextOfAForm) {
  const auto sheen = [](const std::string& corner) {
    return faults_in("float f(float x, float y) { return sqrt(1.0 - x)*(y - 1.0)*y*y*y/(" + corner +
                     " + 1.71228*x - 1.71506*x*y + 1.34174*y*y); }");
  };
  EXPECT_EQ(sheen("0.0000254053"), Words{"zeltner-b right"});
  EXPECT_EQ(sheen("2.54053e-5"), Words{"zeltner-b right"});
  EXPECT_EQ(sheen("0.0000254035"), Words{"zeltner-b typo: 0.0000254053 is 0.0000254035"});
  EXPECT_EQ(sheen("0.000254053"), Words{"zeltner-b wrong: 0.0000254053 is 0.000254053"});
  const auto curve = [](const std::string& last) {
    return faults_in("float f(float x) { return (x*(2.785085*x + 0.107772))/(x*(2.936045*x + 0.887122) + " +
                     last + "); }");
  };
  EXPECT_EQ(curve("0.806889"), Words{"aces-colour right"});
  EXPECT_EQ(curve("0.806898"), Words{"aces-colour typo: 0.806889 is 0.806898"});
}

TEST(LintKnown, ANumberInTheTextOfAFormKeepsItsPlace) {
  for (const KnownSet& set : known_here().sets) {
    if (set.id != "materialx-ggx-scale" || set.form != "biquadratic") continue;
    ASSERT_EQ(set.constants.size(), 17u);
    EXPECT_EQ(set.constants[0].printed, "0.1003");
    EXPECT_TRUE(set.constants[0].is_of_form);
    EXPECT_EQ(set.constants[1].name, "b");
  }
}

// A program may have 4000 kelvin for t > 0.25, and 2222 for t > 1/2.222.
TEST(LintKnown, NotTheNumbersOfAConditionInAForm) {
  for (const KnownSet& set : known_here().sets)
    for (const KnownConstant& constant : set.constants) EXPECT_NE(constant.printed, "2.222") << set.id;
}

TEST(LintKnown, ConstantsThatWerePublishedForOneGivenValue) {
  const auto phase = [](const std::string& k) {
    return faults_in("float f(float c) {\n  const float k = " + k +
                     ";\n  return (1.0 - k * k) / (4.0 * PI * (1.0 - k * c) * (1.0 - k * c));\n}");
  };
  EXPECT_EQ(phase("0.45015"), Words{"hg-schlick right"});
  EXPECT_EQ(phase("0.8112"), Words{"hg-schlick right"});
  EXPECT_EQ(phase("0.45105"), Words{"hg-schlick typo: 0.45015 is 0.45105"});
  EXPECT_EQ(phase("0.7"), Words{});
}

TEST(LintKnown, ANumberOfAFormMayBeThatOfAnotherSource) {
  const auto colour = [](const std::string& b) {
    return faults_in("x = -0.2661239e9/T3 - " + b +
                     "e6/T2 + 0.8776956e3/T + 0.179910\n"
                     "i = -1.1063814*x_3 - 1.34811020*x_2 + 2.18555832*x - 0.20219683\n"
                     "j = -0.9549476*x_3 - 1.37418593*x_2 + 2.09137015*x - 0.16748867\n"
                     "k = 3.0817580*x_3 - 5.8733867*x_2 + 3.75112997*x - 0.37001483\n");
  };
  for (const char* source : {"0.2343580", "0.2343589"})
    for (const std::string& one : colour(source)) EXPECT_TRUE(one.ends_with(" right")) << one;
}

}  // namespace
}  // namespace shadefit::lint
