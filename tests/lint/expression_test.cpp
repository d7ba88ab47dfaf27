#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "fit/formula/parse_formula.hpp"
#include "lint/expression/compare.hpp"
#include "lint/expression/source_expression.hpp"
#include "lint/lint_tree.hpp"
#include "tests/lint/all_known.hpp"

/// Expressions of programs as formulas.
namespace shadefit::lint {
namespace {

/// The value of an expression where its only name is 0.3; NaN if it is not read or has other names.
double at_point_three(std::string_view text, CommentStyle style = CommentStyle::c) {
  const auto formula = read_expression(text, style);
  if (!formula) return std::nan("");
  std::set<std::string> names;
  const double value = evaluate<double>(*formula, [&](const std::string& name) {
    names.insert(name);
    return 0.3;
  });
  return names.size() <= 1 ? value : std::nan("");
}

constexpr double rounding = 1e-15;  // the same operations in another order

TEST(ReadExpression, ReadsEachLanguage) {
  const double x = 0.3, expected = std::pow(x + 0.055, 2.4);
  for (const char* text : {"pow(x + 0.055f, 2.4f)", "std::pow(x + 0.055, 2.4)", "Math.pow(x + 0.055, 2.4)",
                           "np.power(x + 0.055, 2.4)", "(x + 0.055) ** 2.4", "(x + 0.055).powf(2.4)",
                           "x.add(0.055).pow(2.4)", "pow(vec3(x) + vec3(0.055), vec3(2.4))",
                           "powr(x.rgb + .055h, 2.4h)", "pow(vec3<f32>(x) + 0.055, vec3f(2.4))"})
    EXPECT_NEAR(at_point_three(text), expected, rounding) << text;
  EXPECT_NEAR(at_point_three("x**-2", CommentStyle::hash), std::pow(x, -2), 1e-14);
  EXPECT_NEAR(at_point_three("x.mul_add(2.0, 1.0)"), 2 * x + 1, rounding);
  EXPECT_NEAR(at_point_three("x.mul(x.add(0.5)).sub(0.25).div(2)"), (x * (x + 0.5) - 0.25) / 2, rounding);
}

TEST(ReadExpression, AVectorOfEqualComponentsIsANumber) {
  EXPECT_NEAR(at_point_three("x + vec3(0.055, 0.055 , 0.055)"), 0.355, rounding);
  EXPECT_TRUE(std::isnan(at_point_three("x + vec3(0.055, 0.055, 0.05)")));
}

TEST(ReadExpression, AProductWithAVectorIsASum) {
  const auto value = [](std::string_view text) {
    const auto formula = read_expression(text, CommentStyle::c);
    if (!formula) return std::nan("");
    return evaluate<double>(*formula, [](const std::string& name) {
      return name.starts_with("first") ? 1.0 : name.starts_with("second") ? 10.0 : 100.0;
    });
  };
  for (const char* text : {"dot(c, vec3(1, 2, 3))", "dot(float3(1.0, 2.0, 3.0), texture(a, uv).rgb)",
                           "dot(vec3<f32>(1, 2, 3), pow(c, vec3(2.2)))", "np.dot(rgb[0:3], [1, 2, 3])"})
    EXPECT_EQ(value(text), 321) << text;
  // A name, as any other call.
  for (const char* text : {"dot(n, l)", "dot(c, vec2(1, 2))", "dot(c, f(1, 2, 3))"})
    EXPECT_EQ(value(text), 100) << text;
}

TEST(ReadExpression, ASignMayFollowAnOperator) {
  EXPECT_NEAR(at_point_three("1.5 + -0.5 * x"), 1.35, rounding);
  EXPECT_NEAR(at_point_three("1.5 - -x"), 1.8, rounding);
  EXPECT_NEAR(at_point_three("1.5 * -x + 1.0"), 0.55, rounding);
  EXPECT_NEAR(at_point_three("1.5 / -x * 2.0"), -10, 1e-14);
  EXPECT_NEAR(at_point_three("1.5 / - 0.5"), -3, rounding);
  EXPECT_NEAR(at_point_three("+ 2.0 * x"), 0.6, rounding);
  EXPECT_NEAR(at_point_three("(+x) * +2.0 - +x"), 0.3, rounding);
  EXPECT_FALSE(read_expression("++x", CommentStyle::c));
  EXPECT_FALSE(read_expression("2.0 + ++x", CommentStyle::c));
}

TEST(ReadExpression, ACallAMemberAndAnElementAreNames) {
  EXPECT_NEAR(at_point_three("2 * dot(n, l)"), 0.6, rounding);
  EXPECT_NEAR(at_point_three("a.b + a.b"), 0.6, rounding);
  EXPECT_NEAR(at_point_three("a[i + 1] * 2"), 0.6, rounding);
  EXPECT_NEAR(at_point_three("HALF_PI * x"), 0.3 * std::acos(0.0), rounding);
  EXPECT_NEAR(at_point_three("RECIPROCAL_PI * x"), 0.3 / std::acos(-1.0), rounding);
  EXPECT_NEAR(at_point_three("M_1_PI * M_PI * x"), 0.3, rounding);
  EXPECT_NEAR(at_point_three("XE_GTAO_PI * x"), 0.3 * std::acos(-1.0), rounding);
  EXPECT_NEAR(at_point_three("PI_DIV_2 / TAU * x"), 0.3 / 4, rounding);
  EXPECT_TRUE(std::isnan(at_point_three("SQRT_PI * x")));  // a second name
}

TEST(ReadExpression, OtherThanScalarsIsNotRead) {
  for (const char* text : {"vec3(1, 2, 3) * x", "a = x", "x +", "\"x\"", "x; y", "0x1.8p+1 * x"})
    EXPECT_FALSE(read_expression(text, CommentStyle::c)) << text;
}

TEST(ExpressionsAround, GoFromTheInnermostOut) {
  const std::string text = "float f = 2 * g(3 + x * 0.55, y);";
  const std::size_t at = text.find("0.55");
  const auto found = expressions_around(text, at, at + 4);
  ASSERT_GE(found.size(), 2u);
  EXPECT_EQ(found.front(), "3 + x * 0.55");
  EXPECT_NE(found.back().find("2 * g(3 + x * 0.55, y)"), std::string_view::npos);
}

/// The last value around the number 0.55 in a text, where its only name is 0.3.
double value_around(const std::string& text, CommentStyle style = CommentStyle::c) {
  const std::size_t at = text.find("0.55");
  const auto values = values_around(text, at, at + 4, style, read_expression);
  if (values.empty()) return std::nan("");
  return evaluate<double>(values.back(), [](const std::string&) { return 0.3; });
}

TEST(ValuesAround, FollowStatements) {
  EXPECT_NEAR(value_around("{ float a = x * 0.55; float b = a + 1.0; return a / b; }"), 0.165 / 1.165,
              rounding);
  EXPECT_NEAR(value_around("{ float a = x * 0.55; a *= 2.0; a -= x; return a; }"), 0.03, rounding);
  EXPECT_NEAR(value_around("{ let a = 2.0; let b = 0.55; return a * x + b; }"), 1.15, rounding);
  EXPECT_NEAR(value_around("def f(x):\n  a = x * 0.55\n  return a + 1\n", CommentStyle::hash), 1.165,
              rounding);
  EXPECT_NEAR(value_around("{ float a = 0.55, b = 0.1; return x * a + b; }"), 0.265, rounding);
}

TEST(ValuesAround, WhatIsComputedBeforeIsAVariableOrIsNot) {
  const std::string text = "{ float x = 1.0 - y; return 0.55 * x; }";
  const std::size_t at = text.find("0.55");
  const auto values = values_around(text, at, at + 4, CommentStyle::c, read_expression);
  ASSERT_EQ(values.size(), 2u);
  EXPECT_EQ(to_text(values[0]), "0.55 x");
  EXPECT_EQ(to_text(values[1]), "0.55 (1.0 - y)");
}

TEST(ValuesAround, AValueThatGrowsIsLeft) {
  std::string text = "{ float b = 0.55 * x;";
  for (int i = 0; i < 29; ++i) text += " b = b*b - x;";
  const std::size_t at = text.find("0.55");
  text += " return b; }";
  EXPECT_FALSE(values_around(text, at, at + 4, CommentStyle::c, read_expression).empty());
  text = "{ float b = x;" + text.substr(text.find(" b = b*b")) + " return 0.55 * b; }";
  EXPECT_TRUE(values_around(text, text.find("0.55"), text.find("0.55") + 4, CommentStyle::c, read_expression)
                  .size() <= 1);
}

TEST(Mutants, HaveEachKindOfSlip) {
  struct Case {
    const char *formula, *mutant;
    bool is_there = true;
  };
  const std::vector<Case> cases{
      {"a + b", "a - b"},
      {"a + b", "a"},            // a lost term
      {"a - b", "b - a"},        // swapped operands
      {"a (b + c)", "a b + c"},  // lost parentheses
      {"a x + c", "a (x + c)"},  // moved ones
      {"exp(x)", "exp2(x)"},
      {"a/b", "a b"},
      {"x^5", "x^4"},
      {"pow(x, a)", "x^(1/a)"},
      {"pow(x, a)", "x", false},  // the power may be computed elsewhere
      {"a + b", "a + b", false},
      // A factor that is a number may stand elsewhere.
      {"(a + b)/(4 pi)", "a + b", false},
      {"2 (a + b)", "a + b", false},
  };
  for (const auto& [formula, text, is_there] : cases) {
    const auto mutants = mutants_of(read_formula(formula, {.variables = {"a", "b", "c", "x"}}).formula);
    const bool is_found = std::ranges::any_of(
        mutants, [&, &text = text](const Mutant& mutant) { return to_text(mutant.formula) == text; });
    EXPECT_EQ(is_found, is_there) << formula << " as " << text;
  }
}

TEST(MatchExpression, TellsTheSlip) {
  const auto sites = lint_text("float f(float c) { return exp2((-5.55473 * c + 6.98316) * c); }");
  ASSERT_EQ(sites.size(), 1u);
  EXPECT_EQ(sites.front().grade, Grade::wrong);
  EXPECT_NE(sites.front().slip.find(" for "), std::string::npos);
}

TEST(MatchExpression, AProductOfVectorsIsRead) {
  const auto grade = [](const std::string& weights) {
    return grade_in("float f(vec3 c) { return dot(c, vec3(" + weights + ")); }");
  };
  EXPECT_EQ(grade("0.299, 0.587, 0.114"), "right");
  EXPECT_EQ(grade("0.299, 0.587, 0.144"), "wrong");
  EXPECT_EQ(grade("0.212, 0.715, 0.072"), "truncated");
  EXPECT_EQ(grade("0.701, -0.587, -0.114"), "none");  // R - Y
}

TEST(MatchExpression, AVariableAtItsEndTellsNothing) {
  // With g = 0 this would be a sum of two terms with 0.71518 for 0.0722.
  EXPECT_EQ(
      graded(
          "float a = c.r * 0.21260 + c.g * 0.71518 + c.b * 0.07222;\nfloat b = max(a > d ? e : a, 0.0);\n"),
      Words{});
}

TEST(MatchExpression, ATermThatMattersOnlyAtAnEndIsMissed) {
  // 0.000090537 is what is left of the numerator near 0.
  EXPECT_EQ(grade_in("vec3 f(vec3 v) { vec3 a = v * (v + 0.0245786);\n"
                     "vec3 b = v * (0.983729 * v + 0.4329510) + 0.238081;\nreturn a / b; }"),
            "wrong");
}

/// A text of a language, and "ID GRADE" of its only site, or what stands for it.
struct Judged {
  SourceLanguage language;
  std::string text, verdict;
};

void expect_verdicts(const std::vector<Judged>& all) {
  for (const auto& [language, text, verdict] : all) EXPECT_EQ(verdict_in(text, language), verdict) << text;
}

TEST(MatchExpression, AnInnerPowerMayStandElsewhere) {
  using enum SourceLanguage;
  const std::string right = "pq-encode right", wrong = "pq-encode wrong";
  expect_verdicts({
      {hlsl, "float f(float p) { return pow((18.8515625*p + 0.8359375)/(18.6875*p + 1.0), 78.84375); }",
       right},
      {hlsl, "float f(float p) { return pow((0.8359375 + 18.8515625*p)/(1.0 + p*18.6875), 78.84375); }",
       right},
      {glsl,
       "vec3 f(vec3 p) { return pow((vec3(0.8359375) + vec3(18.8515625)*p)/(vec3(1.0) + vec3(18.6875)*p), "
       "vec3(78.84375)); }",
       right},
      {python,
       "def f(y):\n    # y = L ** m1\n    return ((0.8359375 + 18.8515625*y)/(1 + 18.6875*y)) ** 78.84375\n",
       right},
      {hlsl,
       "  r1.xyz = r0.xyz * float3(18.8515625,18.8515625,18.8515625) + float3(0.8359375,0.8359375,0.8359375);\n"
       "  r0.xyz = r0.xyz * float3(18.6875,18.6875,18.6875) + float3(1,1,1);\n  r0.xyz = r1.xyz / r0.xyz;\n"
       "  r0.xyz = log2(r0.xyz);\n  r0.xyz = float3(78.84375,78.84375,78.84375) * r0.xyz;\n"
       "  r0.xyz = exp2(r0.xyz);\n",
       right},
      {hlsl, "float f(float p) { return pow((18.8515625*p + 0.8395375)/(18.6875*p + 1.0), 78.84375); }",
       wrong},
  });
}

TEST(MatchExpression, TwoExchangedConstantsAreASlip) {
  using enum SourceLanguage;
  expect_verdicts({
      {glsl, "float f(float c) { return exp2((-6.98316 * c - 5.55473) * c); }", "fresnel-quadratic wrong"},
      {glsl, "float f(float x) { return (-1.5707963 * x + 0.156583) * sqrt(1.0 - x); }", "acos-linear wrong"},
      {glsl, "float f(float x) { return (1.5707963 * x - 0.156583) * sqrt(1.0 - x); }", "acos-linear wrong"},
      {glsl, "float f(float c) { return c <= 0.04045 ? c / 1.055 : pow((c + 0.055) / 12.92, 2.4); }",
       "srgb-decode-standard wrong"},
      {python, "def f(x):\n  return 1.055*x if x <= 0.0031308 else 12.92*x**(1/2.4) - 0.055\n",
       "srgb-encode-standard wrong"},
      {hlsl, "float3 f(float3 x) { return (x*(2.51*x + 0.03))/(x*(2.43*x + 0.14) + 0.59); }",
       "aces-narkowicz-five wrong"},
      // The order of the channels may be another one.
      {glsl, "float f(vec3 c) { return 0.7152*c.x + 0.2126*c.y + 0.0722*c.z; }", "luma-709 right"},
  });
}

TEST(MatchExpression, OldCodeInACommentIsNotRead) {
  const auto text = [](const std::string& comment) {
    return "float3 f(float3 c) {\n  " + comment +
           "\n  c = log2(c);\n  c = 0.4166667 * c;\n  c = exp2(c);\n  c = c * 1.55 - 0.055;\n  return c;\n}\n";
  };
  for (const char* comment : {"// gamma", "// c = c / d;", "/* c = c / d; */", "// if (c > 1) { c = d;",
                              "float d = 2.0; // c = d; }", "/* c =\n d; */"})
    EXPECT_EQ(verdict_in(text(comment), SourceLanguage::hlsl), "srgb-encode wrong") << comment;
  EXPECT_EQ(verdict_in("def f(c):\n  # c = c / d\n  return exp2((-5.55473*c + 6.98316)*c)\n",
                       SourceLanguage::python),
            "fresnel-quadratic wrong");
  EXPECT_EQ(verdict_in("float f(float c) { return exp2((-5.55473*c // ; a = (\n + 6.98316)*c); }",
                       SourceLanguage::glsl),
            "fresnel-quadratic wrong");
}

TEST(MatchExpression, AVariableThatIsOneMayBeFoldedAway) {
  using enum SourceLanguage;
  expect_verdicts({
      {glsl, "float f() { float Y = 1.0; return 3.2404542*X - 1.5371385 - 0.4985314*Z; }",
       "rec709-red right"},
      {glsl, "float f() { return Z*-0.4985314 + (X*3.2404542 - 1.5371385); }", "rec709-red right"},
      {glsl, "float f() { return Z*0.0415560 + (1.8760108 - X*0.9692660); }", "rec709-green right"},
      {glsl, "float f() { return 0.2126729*r + 0.7151522 + 0.0721750*b; }", "luma-709 right"},
      {hlsl, "float f() { return (1.0 - w)*h + b*mad(-0.4985314, Z, X*3.2404542 - 1.5371385); }",
       "rec709-red right"},
      {glsl, "float f() { return 3.2404542*X + 1.5371385*Y - 0.4985314*Z; }", "rec709-red wrong"},
  });
}

TEST(MatchExpression, AClampIsNoSlip) {
  const std::string before =
      "  r0.xyw = float3(0.416666657,0.416666657,0.416666657) * r0.xyw;\n  r0.xyw = exp2(r0.xyw);\n"
      "  r0.xyw = r0.xyw * float3(1.05499995,1.05499995,1.05499995) + "
      "float3(-0.0549999997,-0.0549999997,-0.0549999997);\n  r1.xyz = ";
  for (const char* clamped :
       {"min(float3(1,1,1), r0.xyw)", "min(1.0, r0.xyw)", "saturate(r0.xyw)", "max(0, min(1, r0.xyw))"}) {
    EXPECT_EQ(verdict_in(before + clamped + ";\n", SourceLanguage::hlsl), "none") << clamped;
    EXPECT_EQ(verdict_in("  r0.xyw = log2(r0.xyw);\n" + before + clamped + ";\n", SourceLanguage::hlsl),
              "srgb-encode right")
        << clamped;
  }
}

TEST(MatchExpression, AnotherThresholdIsFoundWhereTheBranchesNearlyJoin) {
  const auto grade = [](const std::string& t, const std::string& power) {
    return verdict_in("const f = s => s <= " + t + " ? s * 0.0773993808 : Math.pow(" + power + ", 2.4);\n",
                      SourceLanguage::javascript);
  };
  for (const char* power :
       {"s * 0.9478672986 + 0.0521327014", "(s + 0.055) * 0.947867299", "(s + 0.055) / 1.055"}) {
    EXPECT_EQ(grade("0.04045", power), "srgb-decode-standard right");
    EXPECT_EQ(grade("0.040449936", power), "srgb-decode-standard right") << "where the branches join";
    EXPECT_EQ(grade("0.031308", power), "srgb-decode-standard typo");  // 0.12 codes
    EXPECT_EQ(grade("0.4045", power), "srgb-decode-standard wrong");
  }
  EXPECT_EQ(verdict_in("const f = x => x <= 0.031308 ? x * 12.92 : 1.055 * Math.pow(x, 1 / 2.4) - 0.055;\n",
                       SourceLanguage::javascript),
            "srgb-encode-standard wrong");
  EXPECT_EQ(
      verdict_in("const f = s => s <= 0.0031308 ? s / 12.92 : (s * 0.9478672986 + 0.0521327014) ** 2.4;\n",
                 SourceLanguage::javascript),
      "srgb-decode-standard wrong");
}

TEST(MatchExpression, AnInnerPowerMayBeACall) {
  EXPECT_EQ(
      verdict_in("float f(float v) {\n  if (v > 0.003130804954)\n    return 1.055 * pow_1_24(v) - 0.055;\n"
                 "  return 12.92 * v;\n}\n",
                 SourceLanguage::c_family),
      "srgb-encode-standard right");
}

TEST(MatchExpression, ASignalIsMeasuredInCodesWithoutEncodingItAgain) {
  const auto codes = [](const std::string& text) {
    const auto sites = lint_text(text);
    return sites.size() == 1 ? sites.front().effect.srgb_codes : std::nan("");
  };
  EXPECT_NEAR(codes("float f(float x) { return x <= 0.031308 ? 12.92*x : 1.055*pow(x, 1.0/2.4) - 0.055; }"),
              53.64, 0.01);
  // 255 times the largest change, at 1: ((0.8395375 + 18.8515625)/19.6875)^78.84375 - 1.
  EXPECT_NEAR(codes("float f(float y) { float p = pow(y, 0.1593017578125);\n"
                    "return pow((0.8339375 + 18.8515625*p)/(1.0 + 18.6875*p), 78.84375); }"),
              255 * (1 - std::pow(19.6855 / 19.6875, 78.84375)), 0.2);
}

}  // namespace
}  // namespace shadefit::lint
