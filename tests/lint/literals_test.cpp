#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "lint/scan/literals.hpp"

/// Which numbers a text has.
namespace shadefit::lint {
namespace {

std::vector<std::string> numbers_in(std::string_view text, CommentStyle style = CommentStyle::c) {
  std::vector<std::string> numbers;
  for (const Literal& literal : literals_of(text, style))
    numbers.emplace_back(text.substr(literal.offset, literal.length));
  return numbers;
}

using Texts = std::vector<std::string>;

TEST(Literals, HaveTheirSuffix) {
  EXPECT_EQ(numbers_in("1.5f 2.5F 3.5h 4.5lf 5.5_f32 6f64 7.5m"),
            (Texts{"1.5f", "2.5F", "3.5h", "4.5lf", "5.5_f32", "6f64", "7.5m"}));
  EXPECT_EQ(numbers_in("2.5px 3em 0x1F 12abc"), Texts{});
}

TEST(Literals, HaveTheirExponent) {
  EXPECT_EQ(numbers_in("1e-3 2.5E+4 .5e6f 1.e2"), (Texts{"1e-3", "2.5E+4", ".5e6f", "1.e2"}));
  EXPECT_EQ(numbers_in("1e- 2"), Texts{"2"});  // "1e" is a word
}

TEST(Literals, AreNoWordsVersionsOrZeros) {
  EXPECT_EQ(numbers_in("vec3 a1 x_2 1.2.3 0 0.0 4.5"), Texts{"4.5"});
  EXPECT_EQ(numbers_in("\"\\n0.055\""), Texts{"0.055"});  // the letter behind a backslash is no word
}

TEST(Literals, SeparatorsStandBetweenDigits) {
  EXPECT_EQ(numbers_in("1'000.5 1_000.25 'a' 3'"), (Texts{"1'000.5", "1_000.25", "3"}));
  EXPECT_EQ(digits_of("1_000.25"), (Digits{"100025", 4}));
}

TEST(Literals, TooManyDigitsAreNoConstant) {
  const std::string longest = "0." + std::string(most_digits - 2, '1');
  EXPECT_EQ(numbers_in(longest).size(), 1u);
  EXPECT_EQ(numbers_in(longest + "1").size(), 0u);
}

std::vector<bool> comments_in(std::string_view text, CommentStyle style) {
  std::vector<bool> comments;
  for (const Literal& literal : literals_of(text, style)) comments.push_back(literal.is_in_comment);
  return comments;
}

TEST(Literals, KnowComments) {
  const std::vector<bool> only_second{false, true, false};
  EXPECT_EQ(comments_in("1 // 2\n3", CommentStyle::c), only_second);
  EXPECT_EQ(comments_in("1 /* 2 */ 3", CommentStyle::c), only_second);
  EXPECT_EQ(comments_in("1 # 2\n3", CommentStyle::hash), only_second);
  EXPECT_EQ(comments_in("1 # 2 // 4\n3", CommentStyle::none), std::vector<bool>(4, false));
  EXPECT_EQ(comments_in("#define A 1\nhttps://a.b 2", CommentStyle::c), std::vector<bool>(2, false));
}

TEST(Literals, KnowPowersOfTen) {
  for (const char* text : {"5.4 \\times 10^{-13}", "5.4 \\cdot 10^3", "5.4 x 10^3", "5.4 * 10**-4",
                           "5.4\xc3\x97"
                           "10^3"})
    EXPECT_TRUE(literals_of(text, CommentStyle::none).front().has_power_of_ten) << text;
  for (const char* text : {"5.4 * 100", "5.4 * x", "5.4"})
    EXPECT_FALSE(literals_of(text, CommentStyle::none).front().has_power_of_ten) << text;
}

TEST(Digits, AreWithoutSignZerosAndSuffix) {
  EXPECT_EQ(digits_of("-0.0450f"), (Digits{"45", -1}));
  EXPECT_EQ(digits_of("1.5e-3"), (Digits{"15", -2}));
  EXPECT_EQ(digits_of("2500"), (Digits{"25", 4}));
  EXPECT_EQ(digits_of("0.000"), (Digits{"", 0}));
}

}  // namespace
}  // namespace shadefit::lint
