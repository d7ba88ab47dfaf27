#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "lint/lint_tree.hpp"
#include "tests/lint/all_known.hpp"

/// Which numbers belong together, and what they are worth.
namespace shadefit::lint {
namespace {

TEST(Sites, FewDigitsNeedTheOthersOrTheForm) {
  EXPECT_EQ(graded("float f() { return 2.51; }"), Words{});
  EXPECT_EQ(graded("vec3 a = vec3(0.2126, 0.7152, 0.0722);"), Words{"luma-709 right"});
  EXPECT_EQ(graded("float a = 0.2126; int b = 1; int c = 2; float d = 0.0722;"), Words{});
  EXPECT_EQ(graded("float f(float x) { return (x*(2.51*x + 0.03))/(x*(2.43*x + 0.59) + 0.14); }"),
            Words{"aces-narkowicz-five right"});
}

TEST(Sites, AWholeListTellsMore) {
  EXPECT_EQ(graded("vec3 a = vec3(0.2126, 0.7125, 0.0722);"), Words{"luma-709 typo"});
  EXPECT_EQ(graded("int a[] = {5, 0.2126, 0.7125, 0.0722, 9};"), Words{});
}

TEST(Sites, AListMayBeRoundedToTheSameDecimals) {
  const Words truncated{"luma-709 truncated"};
  EXPECT_EQ(graded("const vec3 w = vec3(0.212, 0.715, 0.072);"), truncated);
  EXPECT_EQ(graded("const vec3 w = vec3(0.213, 0.715, 0.072);"), truncated);
  EXPECT_EQ(graded("const vec3 w = vec3(0.212, 0.715, 0.07);"), Words{});   // other decimals
  EXPECT_EQ(graded("const vec3 w = vec3(0.212, 0.715, 0.073);"), Words{});  // another number
  EXPECT_EQ(graded("const vec3 w = vec3(0.072, 0.715, 0.212);"), Words{});  // another order
  EXPECT_EQ(graded("float a = 0.212 + 0.715 + 0.072;"), Words{});           // no list
}

TEST(Sites, AListOfRightNumbersMayHaveASlip) {
  const Words wrong709{"luma-709 wrong"}, wrong601{"luma-601 wrong"};
  EXPECT_EQ(graded("const vec3 LUMA = vec3(0.2126, 0.7152, 0.0772);"), wrong709);
  EXPECT_EQ(
      graded("const vec3 LUMA = vec3(0.2126, 0.7152, 0.0772); float f(vec3 c) { return dot(c, LUMA); }"),
      wrong709);
  EXPECT_EQ(graded("#define LUMA vec3(0.2126, 0.7152, 0.0792)\n"), wrong709);
  EXPECT_EQ(graded("float f(vec3 a) { vec3 d = vec3(0.299, 0.578, 0.114); return dot(a, d); }"), wrong601);
  EXPECT_EQ(graded("w = [0.229, 0.587, 0.114]"), wrong601);
  EXPECT_EQ(graded("vec4 w = vec4(0.299, 0.587, 0.144, 0.0);"), wrong601);
  // Arbitrary numbers near the weights, other decimals, no list, another order.
  for (const char* other :
       {"0.299, 0.5, 0.114", "0.3, 0.59, 0.11", "0.299, 0.587, 0.9", "0.299, 0.587, 0.2126",
        "0.2126, 0.7152, 0.7152", "0.2126, 0.7152, 0.5", "0.2126, 0.7152, 0.07", "0.299, 0.612, 0.114",
        "0.114, 0.578, 0.299", "0.229, 0.587, 0.144", "0.299, 0.578, 0.114, 0.5"})
    EXPECT_EQ(graded(std::string("vec3 w = vec3(") + other + ");"), Words{}) << other;
}

TEST(Sites, EachRowHasTheDecimalsOfItsStandard) {
  const auto rows = [](const std::string& open, const std::string& close) {
    Words all;
    for (const char* row : {"3.2406, -1.5372, -0.4986", "-0.9689, 1.8758, 0.0415", "0.0557, -0.2040, 1.0570"})
      for (const std::string& one : graded("f(" + open + row + close + ");")) all.push_back(one);
    return all;
  };
  const Words right{"rec709-red right", "rec709-green right", "rec709-blue right"};
  EXPECT_EQ(rows("[", "]"), right);
  EXPECT_EQ(rows("vec3(", ")"), right);
  EXPECT_EQ(rows("", ""), right);
  EXPECT_EQ(graded("[[3.2406, -1.5372, -0.4986], [-0.9689, 1.8758, 0.0415], [0.0557, -0.2040, 1.0570]]"),
            right);
  // By columns; those of the blue row have too few digits.
  EXPECT_EQ(graded("mat3(3.2406, -0.9689, 0.0557, -1.5372, 1.8758, -0.2040, -0.4986, 0.0415, 1.0570)"),
            (Words{"rec709-red right", "rec709-green right"}));
  // That of Adobe RGB, whose standard has five decimals.
  EXPECT_EQ(
      graded("[[2.04159, -0.56501, -0.34473], [-0.96924, 1.87597, 0.04156], [0.01344, -0.11836, 1.01517]]"),
      Words{"rec709-green right"});
}

TEST(Sites, InATableOfNumbersAreOnlyCounted) {
  const auto list = [](int count) {
    std::string text = "const float t[] = {\n";
    for (int i = 0; i < count; ++i) text += fmt::format("{}.{:02}, -0.0, // {}\n", i, 7 * i + 11, i);
    return text + "vec3(0.2126f, 0.7125f, 0.0722f), 0.5};";
  };
  EXPECT_EQ(graded(list(20)), Words{"luma-709 typo"});
  EXPECT_EQ(graded(list(70)), Words{});
  SkippedFiles skipped;
  lint_source("a.glsl", list(70), SourceLanguage::glsl, known_here(), {}, keep_going, &skipped);
  EXPECT_EQ(skipped.in_tables, 1U);
  // A statement behind the table is another list.
  EXPECT_EQ(graded(list(70) + "\nvec3 w = vec3(0.2126, 0.7125, 0.0722);"), Words{"luma-709 typo"});
}

TEST(Sites, AConstantThatComesAgainBeginsTheNextSite) {
  const std::string row = "{0.0245786, 0.000090537, 0.983729, 0.4329510, 0.238081},\n";
  EXPECT_EQ(graded(row + row), (Words{"aces-hill right", "aces-hill right"}));
  // Also where the first number of the second row is the one with the wrong digit.
  std::string other = row;
  other.replace(other.find("0.0245786"), 9, "0.0245796");
  EXPECT_EQ(graded(row + other), (Words{"aces-hill right", "aces-hill typo"}));
}

TEST(Sites, NumbersOfCommentsAreApart) {
  const std::string code = "float f(float c) { return exp2((-5.55473 * c - 6.98316) * c); }\n";
  EXPECT_EQ(graded(code + "// not 6.98216\n"), Words{"fresnel-quadratic right"});
  const std::vector<LintedSite> sites = lint_text("// exp2((-5.55473 * c - 6.98316) * c)\n");
  ASSERT_EQ(sites.size(), 1u);
  EXPECT_TRUE(sites.front().is_in_comment);
  // A comment without a formula may break a number.
  EXPECT_EQ(graded("// 0.1593017, 0.8359375, 18.8515625, 18.68, 78.84375\n"), Words{});
}

TEST(Sites, DigitsThatAnotherFormulaPublishesTellNothing) {
  // The end of a row of the decoder and the begin of one of the encoder are no decoder with a wrong
  // threshold.
  std::string text;
  for (const char* x : {"r", "g", "b"})
    text += fmt::format(
        "{0} < 0.04045 ? {0} * (1.0 / 12.92) : pow(({0} + 0.055) * (1.0 / (1 + 0.055)), 2.4),\n", x);
  text += "a);\n} Color to_srgb() const { return Color(\n";
  for (const char* x : {"r", "g", "b"})
    text +=
        fmt::format("{0} < 0.0031308 ? 12.92 * {0} : (1.0 + 0.055) * pow({0}, 1.0f / 2.4f) - 0.055,\n", x);
  for (const std::string& words : graded("return Color(\n" + text + "a); }"))
    EXPECT_TRUE(words.ends_with(" right")) << words;
}

TEST(Sites, ANumberThatComesAgainIsNoOther) {
  // Vectors of one number each, as compilers write them.
  EXPECT_EQ(graded("ge r0, l(0.003131, 0.003131, 0.003131), r1\nmul r3, r1, l(12.92, 12.92, 12.92)\n"
                   "mul r4, r4, l(0.416667, 0.416667, 0.416667)"),
            Words{"srgb-encode-standard truncated"});
  EXPECT_EQ(graded("ge r0, l(0.003131, 0.1, 0.2), r1\nmul r3, r1, l(12.92, 0.3, 0.4)\n"
                   "mul r4, r4, l(0.416667, 0.5, 0.6)"),
            Words{});
  // But the next row of a table is the next site, and so is the next formula with the one number of a set.
  EXPECT_EQ(graded("float f(float c) { return exp2(-8.656170 * c) + exp2(-8.656170 * d); }"),
            (Words{"fresnel-one-term right", "fresnel-one-term right"}));
}

TEST(Sites, EndWithTheirFunction) {
  const std::string first = "vec3 f() { return 0.0245786 + 0.000090537; }\n",
                    second = "vec3 g() { return 0.983729 + 0.4329510; }\n";
  const auto sites = lint_text(first + second);
  ASSERT_EQ(sites.size(), 2u);
  EXPECT_EQ(sites[0].numbers.size(), 2u);
  EXPECT_EQ(lint_text("vec3 f() { return 0.0245786 + 0.000090537\n + 0.983729 + 0.4329510; }").size(), 1u);
}

TEST(Sites, SeveralShiftedNumbersAreOtherUnits) {
  EXPECT_EQ(
      graded("u = (0.860117757 + 1.54118254 * t + 1.28641212 * t*t)/(1 + 8.42420235 * t + 7.08145163 * t*t)"),
      Words{"planck-u right"});
}

// The encoder's threshold is a mistake in a decoder, but not if it stands in an encoder above one.
TEST(Sites, AVariantThatAnotherSetPublishesTellsNothing) {
  const std::string text = R"(
float3 encode(float3 x) {
  float3 low = x * 12.92;
  float3 high = pow(abs(x), float3(1.0 / 2.4, 1.0 / 2.4, 1.0 / 2.4)) * 1.055 - 0.055;
  return float3(x.r <= 0.0031308 ? low.r : high.r, x.g <= 0.0031308 ? low.g : high.g, x.b <= 0.0031308 ? low.b : high.b);
}
float3 decode(float3 u) {
  float3 low = u / 12.92;
  float3 high = pow((u + 0.055) / 1.055, float3(2.4, 2.4, 2.4));
  return float3(u.r <= 0.04045 ? low.r : high.r, u.g <= 0.04045 ? low.g : high.g, u.b <= 0.04045 ? low.b : high.b);
}
)";
  for (const std::string& words : graded(text)) EXPECT_TRUE(words.ends_with(" right")) << words;
}

TEST(Sites, ANumberOfFewDigitsIsTheNearestOne) {
  const auto sites = lint_text(
      "float mip(float m) { return max(1, 10 - m) - 1; }\n"
      "const vec4 c0 = vec4(-1, -0.0275, -0.572, 0.022);\nconst vec4 c1 = vec4(1, 0.0425, 1.04, -0.04);\n");
  ASSERT_EQ(sites.size(), 1u);
  EXPECT_EQ(sites.front().begin.line, 2u);
}

TEST(Sites, ATextCanBeLeftAtEachOfThem) {
  std::string text;
  for (int i = 0; i < 100; ++i) text += "float a = exp2((-5.55473 * c - 6.98316) * c);\n";
  int calls = 0;
  const auto stop = [&] {
    if (++calls == 3) throw std::runtime_error("stop");
  };
  EXPECT_THROW(lint_source("a.glsl", text, SourceLanguage::glsl, known_here(), {}, stop), std::runtime_error);
  EXPECT_EQ(calls, 3);
}

/// "id grade" of the text of a function in each writing: as one expression, as a branch, with vectors, and
/// with a function for the choice.
std::vector<Words> in_each_writing(const std::string& threshold, const std::string& line,
                                   const std::string& power) {
  return {
      graded("float f(float x) { return x <= " + threshold + " ? " + line + " : " + power + "; }"),
      graded("float f(float x) {\n  if (x <= " + threshold + ") return " + line + ";\n  return " + power +
             ";\n}"),
      graded("vec3 f(vec3 x) {\n  vec3 low = " + line + ";\n  vec3 high = " + power +
             ";\n  return vec3(x.r < " + threshold + " ? low.r : high.r, x.g < " + threshold +
             " ? low.g : high.g, x.b);\n}"),
      graded("float3 f(float3 x) { return lerp(" + line + ", " + power + ", step(float3(" + threshold + ", " +
             threshold + ", " + threshold + "), x)); }"),
  };
}

// Four of the five constants are the same: the expression tells which direction it is.
TEST(Sites, TheExpressionTellsTheDirection) {
  const std::string up = "12.92 * x", encode = "1.055 * pow(x, 1.0/2.4) - 0.055", down = "x / 12.92",
                    decode = "pow((x + 0.055)/1.055, 2.4)";
  for (const Words& words : in_each_writing("0.0031308", up, encode))
    EXPECT_EQ(words, Words{"srgb-encode-standard right"});
  for (const Words& words : in_each_writing("0.04045", down, decode))
    EXPECT_EQ(words, Words{"srgb-decode-standard right"});
  for (const Words& words : in_each_writing("0.0031308", down, decode))
    EXPECT_EQ(words, Words{"srgb-decode-standard wrong"});
}

TEST(Sites, TheEncoderMayHaveTheThresholdOfTheDecoder) {
  EXPECT_EQ(graded("float f(float x) { return x <= 0.04045 ? 12.92 * x : 1.055 * pow(x, 1.0/2.4) - 0.055; }"),
            Words{"srgb-encode-standard wrong"});
}

TEST(Sites, AThresholdThatIsComputedIsNoWrongOne) {
  const std::string begin = "float f(float v) {\n  float l = pow((v + 0.055) / 1.055, 2.4);\n  if (v <= ",
                    end = ")\n    l = v / 12.92;\n  return l;\n}";
  EXPECT_EQ(graded(begin + "encoded(0.0031308)" + end), Words{"srgb-decode-standard right"});
  EXPECT_EQ(graded(begin + "float(0.0031308)" + end), Words{"srgb-decode-standard wrong"});
  EXPECT_EQ(graded(begin + "0.0031308" + end), Words{"srgb-decode-standard wrong"});
}

// An expression that was read before is not read again, whatever its names.
TEST(Sites, ExpressionsDifferByThePlacesOfTheirNames) {
  const std::string one = "float f(float c) { return exp2((-5.55473*c + 6.98316)*c); }\n",
                    same = "float g(float x) { return exp2((-5.55473*x + 6.98316)*x); }\n",
                    other = "float h(float c, float d) { return exp2((-5.55473*c + 6.98316)*d); }\n";
  const std::string wrong = "fresnel-quadratic wrong", right = "fresnel-quadratic right";
  EXPECT_EQ(graded(one + same + other), (Words{wrong, wrong, right}));
  EXPECT_EQ(graded(other + same + one), (Words{right, wrong, wrong}));
}

TEST(Grade, LimitsHaveTwoSides) {
  const std::string text = "float f(float c) { return exp2((-5.55473 * c - 6.97316) * c); }\n";
  const std::vector<LintedSite> sites = lint_text(text);
  ASSERT_EQ(sites.size(), 1u);
  ASSERT_TRUE(sites.front().is_shown);
  const double codes = sites.front().effect.srgb_codes, change = sites.front().effect.absolute.magnitude;
  EXPECT_EQ(lint_text(text, SourceLanguage::glsl, {.codes = codes * 0.999}).front().grade, Grade::wrong);
  EXPECT_EQ(lint_text(text, SourceLanguage::glsl, {.codes = codes * 1.001}).front().grade, Grade::typo);
  EXPECT_EQ(lint_text(text, SourceLanguage::glsl, {.of_all = change * 0.999}).front().grade, Grade::wrong);
  EXPECT_EQ(lint_text(text, SourceLanguage::glsl, {.of_all = change * 1.001}).front().grade, Grade::typo);
  // The largest effect of such a change of b is near c = 1/7: there c exp2(-b c) ln 2 is largest.
  EXPECT_NEAR(change, 0.01 * 0.6931 * 0.1350 * std::exp2((-5.55473 * 0.1350 - 6.98316) * 0.1350), 2e-5);
}

TEST(Grade, FewerDigitsAreTruncated) {
  EXPECT_EQ(graded("float f(float c) { return exp2((-5.555 * c - 6.983) * c); }"),
            Words{"fresnel-quadratic truncated"});
  EXPECT_EQ(grade_of_other({"b", "-0.00232", -0.00232}, -0.0023), Grade::truncated);
  EXPECT_EQ(grade_of_other({"b", "-0.00232", -0.00232}, -0.0025), Grade::typo);
}

TEST(Grade, AReplacedNumberIsTheNearest) {
  const std::string line = "float f(float c) { return exp2((-5.55473 * c - 6.99) * c); }\n";
  const std::vector<LintedSite> sites = lint_text(line + line);
  ASSERT_EQ(sites.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(sites[i].numbers.size(), 2u);
    EXPECT_EQ(sites[i].begin.line, static_cast<long>(i) + 1);
    EXPECT_EQ(sites[i].end.line, static_cast<long>(i) + 1);
  }
}

TEST(Grade, AReplacedValueIsOutdatedWithItsReason) {
  const auto sites =
      lint_text("float f(float u) { return u <= 0.03928 ? u/12.92 : pow((u + 0.055)/1.055, 2.4); }");
  ASSERT_EQ(sites.size(), 1u);
  EXPECT_EQ(sites.front().grade, Grade::outdated);
  EXPECT_NE(sites.front().replaced.find("0.04045"), std::string::npos);
}

}  // namespace
}  // namespace shadefit::lint
