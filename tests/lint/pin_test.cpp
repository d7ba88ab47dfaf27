#include <gtest/gtest.h>

#include <list>
#include <string>

#include "lint/pins.hpp"
#include "tests/lint/all_known.hpp"

/// Marks that pin a number to a published constant.
namespace shadefit::lint {
namespace {

/// "NUMBER NAME" for each mark of a text.
Words marks(const std::string& text) {
  Words found;
  for (const Pin& pin : pins_of(text)) {
    EXPECT_EQ(text.substr(pin.offset, pin.name.size()), pin.name);
    if (!pin.number.empty()) {
      EXPECT_EQ(text.substr(pin.number_offset, pin.number.size()), pin.number);
    }
    found.push_back(std::string(pin.number) + " " + std::string(pin.name));
  }
  return found;
}

TEST(Pins, StandInCommentsOfEveryKind) {
  EXPECT_EQ(marks("a = 1.5f; // shadefit: x.a\n"), Words{"1.5f x.a"});
  EXPECT_EQ(marks("a = .5 # shadefit: x-y.form.a\n"), Words{".5 x-y.form.a"});
  EXPECT_EQ(marks("2e-3 /// shadefit:x.a"), Words{"2e-3 x.a"});
  EXPECT_EQ(marks("0.25 <!-- shadefit: x.a-->"), Words{"0.25 x.a"});
  EXPECT_EQ(marks("a * 1.5 /* shadefit: x.a */ + 2.5_f32 /* shadefit: x.b */;"),
            (Words{"1.5 x.a", "2.5_f32 x.b"}));
}

TEST(Pins, TakeTheLastNumberOfTheLine) {
  EXPECT_EQ(marks("3.5\nvec2(1.5, v.x2 * -2.5); // shadefit: x.a, as printed."), Words{"2.5 x.a"});
  EXPECT_EQ(marks("mix(1.0, 0.0) // shadefit: x.a"), Words{" x.a"});
  EXPECT_EQ(marks("1.5 + 0x1F // shadefit: x.a"), Words{" x.a"}) << "never the one before";
  for (const char* number : {"0x1.921fb6p+0", "0X1.921FBP0", "0x1.8p-1f", "0x1.9'2p+0"})
    EXPECT_EQ(marks("1.5 + " + std::string(number) + "; // shadefit: x.a"), Words{" x.a"}) << number;
  EXPECT_EQ(marks("1.5 + 1.2.3; // shadefit: x.a"), Words{" x.a"});
  EXPECT_EQ(marks("1.5 .. 0..5; // shadefit: x.a"), Words{" x.a"});
  EXPECT_EQ(marks("5.5.sqrt() // shadefit: x.a"), Words{"5.5 x.a"});
  EXPECT_EQ(marks("1.5\n// shadefit: x.a\n2.5"), Words{" x.a"});
  EXPECT_EQ(marks("1.5 /* shadefit: x.a */ /* shadefit: x.b */"), (Words{"1.5 x.a", " x.b"}));
}

TEST(Pins, OtherWordsAreNone) {
  EXPECT_TRUE(marks("1.5 // shadefit: ignore as in 2012").empty());
  EXPECT_TRUE(marks("1.5 // see shadefit: x.a").empty());
  EXPECT_TRUE(marks("shadefit: x.a").empty());
  EXPECT_TRUE(marks("1.5 // shadefit: (c)").empty());
}

TEST(Ignoring, IsAWordAtTheStartOfAComment) {
  EXPECT_EQ(ignore_reason("a; // shadefit:ignore because").value_or(""), "because");
  EXPECT_EQ(ignore_reason("/* shadefit: ignore: as in 2012 */ a").value_or(""), "as in 2012");
  EXPECT_EQ(ignore_reason("1.5 /* shadefit: x.a */ // shadefit: ignore").value_or(""), "no reason given");
  for (const char* line : {"// shadefit: ignored values", "a = \"shadefit: ignore me\";", "// shadefit: x.a",
                           "// not shadefit: ignore me", "// shadefit: ignore-me"})
    EXPECT_FALSE(ignore_reason(line)) << line;
}

LintedSite judged(const std::string& number, const std::string& name) {
  // The parts of a pin point into its text.
  static std::list<std::string> texts;
  texts.push_back(number + " // shadefit: " + name);
  return judge_pin(pins_of(texts.back()).at(0), known_here().sets, {});
}

Grade grade_of_pin(const std::string& number, const std::string& name) {
  const LintedSite pin = judged(number, name);
  EXPECT_EQ(pin.fault, "");
  return pin.grade;
}

TEST(Pins, AreRightWithThePublishedDigits) {
  for (const char* number : {"1.5707963", "1.57079630", "1.5707963267948966", "1.57079625f", "15707963e-7"})
    EXPECT_EQ(grade_of_pin(number, "acos-linear.a"), Grade::right) << number;
  EXPECT_EQ(grade_of_pin("0.156583", "acos-linear.linear.b"), Grade::right) << "the sign stands outside";
  EXPECT_EQ(grade_of_pin("0.774999976", "sg-offset.x"), Grade::right) << "the float, of few digits too";
}

TEST(Pins, AreGradedByTheirEffect) {
  EXPECT_EQ(grade_of_pin("1.57079", "acos-linear.a"), Grade::truncated);
  EXPECT_EQ(grade_of_pin("1.5707936", "acos-linear.a"), Grade::typo) << "moves the curve by 3e-6";
  EXPECT_EQ(grade_of_pin("1.57", "acos-linear.a"), Grade::truncated) << "moves the curve by 8e-4";
  EXPECT_EQ(grade_of_pin("1.56", "acos-linear.a"), Grade::wrong) << "moves the curve by 0.011";
  EXPECT_NEAR(judged("1.56", "acos-linear.a").effect.absolute.magnitude, 0.0107963, 1e-9)
      << "at x = 0, the difference of the constants";
}

TEST(Pins, MayHaveTheNumberOfAnySource) {
  // Two sources published this offset, 0.775 and 0.788.
  EXPECT_EQ(grade_of_pin("0.775", "sg-offset.x"), Grade::right);
  EXPECT_EQ(grade_of_pin("0.788", "sg-offset.x"), Grade::right);
  EXPECT_NE(grade_of_pin("0.778", "sg-offset.x"), Grade::right);
}

TEST(Pins, OfUnknownNamesAreFaults) {
  EXPECT_EQ(judged("1.5", "acos-liner.a").fault,
            "no published constant has the name 'acos-liner.a'; did you mean 'acos-linear.a'?");
  EXPECT_EQ(judged("1.5", "acos-linear.liner.a").fault,
            "no published constant has the name 'acos-linear.liner.a'; did you mean 'acos-linear.linear.a'?");
  EXPECT_EQ(judged("1.5", "unheard").fault, "no published constant has the name 'unheard'");
  EXPECT_EQ(judged("", "acos-linear.a").fault, "'acos-linear.a' has no decimal number before it in its line");
}

TEST(Pins, OfSeveralFormsNeedTheForm) {
  EXPECT_EQ(
      judged("1.055", "srgb-encode-standard.b").fault,
      "several published forms have 'srgb-encode-standard.b'; write srgb-encode-standard.reciprocal.b or "
      "srgb-encode-standard.standard.b");
  EXPECT_EQ(grade_of_pin("1.055", "srgb-encode-standard.reciprocal.b"), Grade::right);
  EXPECT_EQ(grade_of_pin("2.4", "srgb-encode-standard.p"), Grade::right) << "one form alone has it";
}

TEST(Pins, KnowWhatWasReplaced) {
  const LintedSite draft = judged("0.00304", "srgb-encode-standard.standard.t");
  EXPECT_EQ(draft.grade, Grade::outdated);
  EXPECT_EQ(draft.replaced, "IEC 61966-2-1:1999 has 0.0031308; 0.00304 is the draft's");
}

}  // namespace
}  // namespace shadefit::lint
