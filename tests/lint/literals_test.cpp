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

/// Whether the last number of a text is in a comment.
bool ends_in_comment(std::string_view text, CommentStyle style) {
  return comments_in(text, style).back();
}

TEST(Literals, NoCommentBeginsInQuotes) {
  for (const char* text :
       {R"y(glob("src/*.glsl"); 2)y", R"y(f("//x", 2))y", R"y(f('//x', 2))y", R"y(f("\"//x", 2))y",
        R"y(c = '"'; d = "//"; 2)y", R"y(c = '\''; d = '//'; 2)y", "#error don't\n2"})
    EXPECT_FALSE(ends_in_comment(text, CommentStyle::c)) << text;
  for (const char* text : {R"y(f<'a>(x: &'a str) { g("//x"); 2)y", R"y(let c = '"'; let d = "//"; 2)y"})
    EXPECT_FALSE(ends_in_comment(text, CommentStyle::rust)) << text;
  for (const char* text : {R"y(f("#x", 2))y", "f('#x', 2)", "#define A 2", "  #define A 2"})
    EXPECT_FALSE(ends_in_comment(text, CommentStyle::hash)) << text;
}

TEST(Literals, CommentsBeginBesideQuotes) {
  for (const char* text :
       {R"y(f("x"); // 2)y", R"y(f("x" /* 2)y", R"y(c = '"'; // 2)y", "// don't 1\n// 2", "/* don't */ /* 2",
        R"y(f("open // 2)y", "n = 0xFF'FF; // it's 2", "a = b / c; // 2 / 3"})
    EXPECT_TRUE(ends_in_comment(text, CommentStyle::c)) << text;
  for (const char* text : {"fn f<'a>(x: &'a str) { // don't 2", "'a: loop { // 2", R"y(let c = '\''; // 2)y"})
    EXPECT_TRUE(ends_in_comment(text, CommentStyle::rust)) << text;
  for (const char* text : {R"y(f("x") # 2)y", "# don't\n# 2", "#defined 2", "x #define 2"})
    EXPECT_TRUE(ends_in_comment(text, CommentStyle::hash)) << text;
}

TEST(Digits, AreWithoutSignZerosAndSuffix) {
  EXPECT_EQ(digits_of("-0.0450f"), (Digits{"45", -1}));
  EXPECT_EQ(digits_of("1.5e-3"), (Digits{"15", -2}));
  EXPECT_EQ(digits_of("2500"), (Digits{"25", 4}));
  EXPECT_EQ(digits_of("0.000"), (Digits{"", 0}));
}

}  // namespace
}  // namespace shadefit::lint
