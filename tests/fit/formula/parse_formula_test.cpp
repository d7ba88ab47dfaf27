#include "fit/formula/parse_formula.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <initializer_list>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>

#include "approx/fresnel.hpp"
#include "approx/lobe.hpp"
#include "approx/normalisation.hpp"
#include "fit/proof/interval_ends.hpp"
#include "fit/scalars/multiprecision.hpp"
#include "tests/any_expression.hpp"
#include "tests/refusal.hpp"

namespace shadefit {
namespace {

constexpr std::array<std::string_view, 3> variables{"a", "b", "cos_theta"};

Symbolic parse(std::string_view text) {
  return parse_formula(text, variables);
}

double value_of(std::string_view text) {
  return evaluate<double>(parse(text), [](const std::string& name) { return name == "a" ? 3.0 : 0.5; });
}

/// Each formula "is" a number.
void expect_values(std::initializer_list<std::string_view> all) {
  for (const std::string_view text : all) {
    const std::size_t is = text.find(" is ");
    EXPECT_EQ(value_of(text.substr(0, is)), std::stod(std::string(text.substr(is + 4)))) << text;
  }
}

const FormulaNames three_names{.variables = {"a", "b", "cos_theta"}};

std::string error_of(std::string_view text, const FormulaNames& names = three_names) {
  return testing::refusal<std::invalid_argument>([&] { read_formula(text, names); });
}

void expect_error(const std::string& text, const std::string& expected,
                  const FormulaNames& names = three_names) {
  EXPECT_EQ(error_of(text, names), "formula '" + text + "': expected " + expected);
}

TEST(ParseFormula, ReadsAsPeopleMeanIt) {
  expect_values({"2 is 2", "a - (1 - b) is 2.5", "a*b*4 is 6", "3 a/(2 b) is 9", "4^b is 2", "4^(-b) is 0.5",
                 "4^1.5 is 8", "2.5e1 a is 75", "max(a, 4) + exp2(a) + sqrt(cos_theta + 3.5) is 14",
                 "(a < b ? 1 : 2) is 2", "(b < a ? 1 : 2) a is 3", "a*-b is -1.5", "a + -b is 2.5",
                 "a*2 b is 3"});
  EXPECT_EQ(value_of(" ( a+2 ) (a + 4)/ 8"), 35.0 / 8);
  EXPECT_EQ(value_of("a^-2"), 1.0 / 9);
  EXPECT_EQ(value_of("pi/ln2"), pi<double>() / ln2<double>());
  EXPECT_EQ(value_of("1 - a - b"), -2.5) << "sums run from the left";
  EXPECT_EQ(value_of("-a b + 1"), -0.5) << "a sign covers the product";
  EXPECT_EQ(value_of("-a^2"), -9) << "and the power";
  EXPECT_EQ(value_of("a/b/2"), 3) << "quotients run from the left";
  EXPECT_EQ(value_of("1/2*(a + 1)"), 2) << "as in C";
  EXPECT_EQ(value_of("a\tb\n* 2"), 3) << "any space separates";
  EXPECT_EQ(parse("(1 - a)^5").kind(), Symbolic::Kind::integer_power) << "multiplications";
  EXPECT_EQ(parse("(1 - a)^b").kind(), Symbolic::Kind::real_power);
}

TEST(ParseFormula, SaysWhereItStopped) {
  expect_error("(a+2", "')' at place 5");
  expect_error("", "a number, a name or '(' at place 1");
  expect_error("a +", "a number, a name or '(' at place 4");
  expect_error("a)", "an operator or the end at place 2");
  expect_error("2 alpha", "one of a, b, cos_theta, pi, ln2 and the functions, not 'alpha' at place 3");
  expect_error("1/2 pi", "parentheses around the quotient or its denominator at place 5");
  for (const char* text :
       {"a/b 2",       "a/2 b",      "1/2(a + 1)", "a^b^2",       "a^-b",      "2 3",
        "a 3",         "--a",        ".",          "max(a)",      "max(a, b",  "sqrt a",
        "sqrt(a, b)",  "(a < b)",    "a < b",      "(a < b ? 1)", "a ? b : 1", "a && b < 1 ? 1 : 2",
        "(a < b) + 1", "!a ? 1 : 2", "a % b",      "a = b",       "1e999",     "a^99999999999",
        "A",           "a\vb",       "2(a",        "2f",          "3h",        "a.x"}) {
    EXPECT_NE(error_of(text).find("expected"), std::string::npos) << text;
  }
  const std::string nul("a\0b", 3);
  EXPECT_NE(error_of(nul), "");
}

// Expressions of Python, and numbers that shadefit prints.
TEST(ParseFormula, ReadsPython) {
  expect_values({"a**2 is 9", "4**(-b)*2 is 1"});
  EXPECT_EQ(value_of("1/a**2"), 1.0 / 9);
  EXPECT_EQ(value_of("a**-2"), 1.0 / 9);
  EXPECT_EQ(value_of("-a**2 + 2*a ** 2"), 9) << "as ^";
  expect_error("a**b**2", "parentheses around one of the powers at place 5");
  expect_error("a* *b", "a number, a name or '(' at place 4");
  EXPECT_EQ(to_text(parse("arccos(b) + arcsin(b) + arctan(b) + arctan2(a, b)")),
            to_text(parse("acos(b) + asin(b) + atan(b) + atan2(a, b)")));
  EXPECT_EQ(to_text(parse("arccosh(a) + arcsinh(a) + arctanh(b)")),
            to_text(parse("acosh(a) + asinh(a) + atanh(b)")));
  EXPECT_EQ(value_of("np.maximum(a, 4) + numpy.clip(a, 0, 1) + math.fabs(-a) + np.power(a, 2)"), 17);
  EXPECT_EQ(value_of("np.pi/math.pi + np.log(np.e)"), 2);
  EXPECT_EQ(to_text(parse("np.arccos(b)")), "acos(b)");
  EXPECT_NE(error_of("torch.acos(a)").find("expected"), std::string::npos);
  expect_error("np.dog(a)", "a function after 'np.', not 'dog' (did you mean 'log'?) at place 4");
  expect_values({"0x1.8p+3 + 0x1p-1 a is 13.5", "-0x1.999999999999ap-4 is -0.1", "a - 0x0p+0 is 3",
                 "0x0.0000000000001p-1022 a/0x0.0000000000001p-1022 is 3"});
  EXPECT_EQ(parse("0x1.8p+1").name(), "3");
  EXPECT_EQ(parse("0x1.999999999999ap-4").name(),
            "0.1000000000000000055511151231257827021181583404541015625");
  for (const char* text : {"0x1.80p+1", "0x1.8p+9999", "0x3p+1", "0x1.8p+01"})
    EXPECT_NE(error_of(text).find("a hexadecimal double as shadefit prints it"), std::string::npos) << text;
}

// Expressions of shaders and of C, as they stand there.
TEST(ParseFormula, ReadsShaderCode) {
  expect_values({"saturate(a) is 1", "clamp(a - 5.0f, -1.0, b) is -1", "mix(1.0, 3.0, b) is 2",
                 "lerp(1.0h, 3.0h, b) is 2", "mad(a, b, .5) is 2", "fma(a, b, 1e0f) is 2.5",
                 "step(a, b) + 2.*step(b, a) is 2", "smoothstep(0., 1., b) is 0.5", "pow(a, 2.0) is 9"});
  EXPECT_EQ(parse("pow(a - 4, 2.0)").kind(), Symbolic::Kind::integer_power) << "of a negative base too";
  EXPECT_EQ(parse("pow(a, 2.5)").kind(), Symbolic::Kind::real_power);
  expect_values({"powf(a, 2) + fabsf(-a) + fminf(a, b) is 12.5", "rcp(b) + rsqrt(4.) + inversesqrt(4.) is 3",
                 "ceil(b) + floor(b) + fract(a + b) is 1.5", "atan(a, b) - atan2(a, b) is 0",
                 "sign(-a) + abs(-a) is 2"});
  EXPECT_EQ(value_of("mod(-a, 2.) + 10*fmod(-a, 2.)"), -9) << "mod rounds down, fmod towards zero";
  EXPECT_NEAR(value_of("log10(1000.)"), 3, 1e-15);
  expect_values({"M_PI/PI is 1", "a <= 3 ? 1 : 2 is 1", "a < 3 ? 1 : a == 3 ? 4 : 5 is 4",
                 "a != 3 ? 1 : 2 is 2", "a >= 3 && b > 1 ? 1 : 2 is 2", "a >= 3 || b > 1 ? 1 : 2 is 1",
                 "!(a >= 3 || b > 1) && !(b < 0) ? 1 : 2 is 2"});
  expect_error("2f a", "a point before the suffix, 2.0f, or a '*' at place 1");
  expect_error("max(a)", "2 arguments of 'max' at place 1");
  expect_error("(a < b) + 1", "a number, not a condition at place 1");
  expect_error(
      "sqr(a)",
      "one of a, b, cos_theta, pi, ln2 and the functions, not 'sqr' (did you mean 'sqrt'?) at place 1");
}

/// Within some roundings of C's own functions, where these cancel too: next to 0.
TEST(ParseFormula, ReadsTheOtherFunctionsOfShaders) {
  constexpr double few = 1e-15;
  const auto expect = [](std::string_view text, double expected) {
    EXPECT_NEAR(value_of(text), expected, few * std::abs(expected)) << text;
  };
  expect("radians(180.)", std::numbers::pi);
  expect("degrees(PI/2)", 90);
  expect("asinh(a)", std::asinh(3.0));
  expect("asinh(-a/1e9)", std::asinh(-3e-9));
  expect("acosh(a)", std::acosh(3.0));
  expect("atanh(b)", std::atanh(0.5));
  expect("atanh(-a/1e9)", std::atanh(-3e-9));
  expect("cbrt(a - 11)", -2);
  expect("hypot(a, -4.)", 5);
}

// A line of a shader: casts, C's constants, suffixes and the end of a statement.
TEST(ParseFormula, ReadsPastedLines) {
  expect_values({"(float)a + (half)b*2 is 4", "(float)(half)a^2 is 9",
                 "half(a) + double(b) + float(1) is 4.5", "std::max(a, std::abs(-4.0f)) is 4",
                 "a < b ? 1 : std::floor(b) is 0", "2u*a + 1U ; is 7", "a; is 3"});
  EXPECT_EQ(value_of("( double ) (a + 1)/2 - (float)-a"), 5) << "a cast binds as in C";
  expect_error("a;;", "an operator or the end at place 3");
  expect_error("a; b",
               "one expression, not statements (a definition, as of --let, can name a part) at place 2");
  expect_error("std::sqr(a)", "a function after 'std::', not 'sqr' (did you mean 'sqrt'?) at place 6");
  expect_error("(int)a", "a cast to a real number, not to 'int' (trunc drops the fraction) at place 2");
  expect_error("(float)-a^2", "parentheses around the base of the power at place 10");
  EXPECT_NE(error_of("1.u"), "");
  EXPECT_NE(error_of("1ul"), "");
  std::string casts;
  for (int i = 0; i < 500; ++i) casts += "(half)";
  EXPECT_NE(error_of(casts + "a").find("no more than 100 casts"), std::string::npos);
}

// In one of these a name before u decides, in the other it may be a parameter.
TEST(ReadFormula, TakesUAsASuffixWhereItIsNoName) {
  const auto read = [](std::string_view text, const FormulaNames& names) {
    return to_text(read_formula(text, names).formula);
  };
  EXPECT_EQ(read("2u x", {.variables = {"x"}}), "2 x");
  EXPECT_EQ(read("2u x", {.variables = {"x", "u"}}), "2 u x");
  expect_error("a + 2u x", "no suffix, or a '*': in a form 2u may be 2*u at place 5",
               {.variables = {"x"}, .takes_parameters = true});
}

TEST(ParseFormula, RefusesVectorsByName) {
  const std::string vector = "' (vectors are not part of the language) at place ";
  expect_error("float3(a, a, a)", "a real number, not 'float3" + vector + "1");
  expect_error("1 + vec3(a).x", "a real number, not 'vec3" + vector + "5");
  expect_error("(half4)a", "a real number, not 'half4" + vector + "2");
  expect_error("dot(a, b)", "a real number, not 'dot" + vector + "1");
  for (const char* text : {"mat3(a)", "float4x4(a)", "mat2x3(a)", "ivec2(a)", "normalize(a)"})
    EXPECT_NE(error_of(text).find(vector), std::string::npos) << text;
  expect_error(
      "a.xyz",
      "an operator or the end, not '.xyz' (swizzles and members are not part of the language) at place 2");
  EXPECT_NE(error_of("max(a, (b).r)").find("not '.r' (swizzles"), std::string::npos);
  expect_error(
      "a%2", "an operator or the end, not '%' (it is not part of the language: mod and fmod are) at place 2");
  EXPECT_NE(error_of("max(a % 2, b)").find("not '%'"), std::string::npos);
  EXPECT_NE(error_of("k float3(x)", {.variables = {"x"}, .takes_parameters = true}).find(vector),
            std::string::npos)
      << "in a form too";
}

// The functions that round, by C's own, in double and in 50 digits.
TEST(ParseFormula, RoundsAsC) {
  const Symbolic rounded = parse("round(a)"), truncated = parse("truncf(a)");
  for (const double x :
       {-7.0, -2.5, -2.4, -1.5, -0.75, -0.5, -0.25, 0.0, 0.25, 0.5, 0.75, 1.5, 2.5, 2.6, 1e6}) {
    const auto given = [&](const std::string&) { return x; };
    EXPECT_EQ(evaluate<double>(rounded, given), std::round(x)) << x;
    EXPECT_EQ(evaluate<double>(truncated, given), std::trunc(x)) << x;
    const auto wide = [&](const std::string&) { return Decimal50(x); };
    EXPECT_EQ(evaluate<Decimal50>(rounded, wide), Decimal50(std::round(x))) << x;
    EXPECT_EQ(evaluate<Decimal50>(truncated, wide), Decimal50(std::trunc(x))) << x;
    const auto box = [&](const std::string&) { return Interval(x); };
    EXPECT_EQ(lower_end(evaluate<Interval>(rounded, box)), std::round(x)) << x;
    EXPECT_EQ(upper_end(evaluate<Interval>(truncated, box)), std::trunc(x)) << x;
  }
  for (const Symbolic& formula : {rounded, truncated})
    EXPECT_EQ(to_text(parse(to_text(formula))), to_text(formula));
}

// The constants of math.h.
TEST(ParseFormula, KnowsTheConstantsOfC) {
  const std::map<std::string, double> constants{
      {"M_PI", M_PI},        {"M_PI_2", M_PI_2},         {"M_PI_4", M_PI_4},   {"M_1_PI", M_1_PI},
      {"M_2_PI", M_2_PI},    {"M_2_SQRTPI", M_2_SQRTPI}, {"M_SQRT2", M_SQRT2}, {"M_SQRT1_2", M_SQRT1_2},
      {"M_E", M_E},          {"M_LN2", M_LN2},           {"M_LN10", M_LN10},   {"M_LOG2E", M_LOG2E},
      {"M_LOG10E", M_LOG10E}};
  for (const auto& [name, value] : constants) EXPECT_NEAR(value_of(name) / value, 1, 4e-16) << name;
}

// In a form every other name is a parameter; definitions are put in.
TEST(ReadFormula, FindsParametersAndPutsDefinitionsIn) {
  constexpr std::array<std::string_view, 1> t{"t"};
  const FormulaNames names{
      .variables = {"x"},
      .definitions = {{"g", {{"t"}, parse_formula("t + 1", t)}}, {"half", {{}, parse_formula("1/2", {})}}},
      .takes_parameters = true};
  const ReadFormula read = read_formula("sqrt(1-x)(b + a x) + k(x) + b half", names);
  EXPECT_EQ(read.parameters, (std::vector<std::string>{"b", "a", "k"}));
  EXPECT_EQ(to_text(read.formula), "sqrt(1 - x) (b + a x) + k x + b (1/2)");
  EXPECT_EQ(to_text(read_formula("g(2 x) + e", names).formula), "2 x + 1 + e");
  expect_error("sqr(x)", "a function before '(', not 'sqr' (did you mean 'sqrt'?) at place 1", names);
  expect_error("f0(x)", "a function before '(', not 'f0'; a product needs a '*' or a space at place 1",
               names);
  EXPECT_EQ(error_of("f0 (x)", names), "");
  expect_error("g(x, x)", "1 argument of 'g' at place 2", names);
}

// With a list of parameters no other name is one.
TEST(ReadFormula, KeepsToAListOfParameters) {
  const FormulaNames names{.variables = {"x"}, .takes_parameters = true, .parameters = {"b", "scale"}};
  EXPECT_EQ(read_formula("scale x + b", names).parameters, (std::vector<std::string>{"scale", "b"}));
  expect_error("scale x + c", "one of x, b, scale, pi, ln2 and the functions, not 'c' at place 11", names);
  expect_error(
      "b + scael x",
      "one of x, b, scale, pi, ln2 and the functions, not 'scael' (did you mean 'scale'?) at place 5", names);
  expect_error("b sqr(x)",
               "one of x, b, scale, pi, ln2 and the functions, not 'sqr' (did you mean 'sqrt'?) at place 3",
               names);
  expect_error("scale(x)", "a function before '(', not 'scale'; a product needs a '*' or a space at place 1",
               names);
}

TEST(ParseFormula, BoundsItsDepth) {
  const auto nested = [](int n) {
    return std::string(static_cast<std::size_t>(n), '(') + "a" +
           std::string(static_cast<std::size_t>(n), ')');
  };
  EXPECT_EQ(value_of(nested(99)), 3);
  EXPECT_NE(error_of(nested(100)).find("nested"), std::string::npos);
  EXPECT_NE(error_of(std::string(500, '(')).find("nested"), std::string::npos) << "no overflow";
}

// What an expression prints is read back as that expression: it prints the same, and the text of the reading
// is the text. (A negative number is read as the negated number, which prints alike.)
TEST(ParseFormula, ReadsBackWhatExpressionsPrint) {
  testing::AnyExpression any(1, {"a", "cos_theta"});
  for (int i = 0; i < 5000; ++i) {
    const std::string text = to_text(any.of_depth(4));
    ASSERT_EQ(to_text(parse(text)), text);
  }
  const Symbolic a = Symbolic::variable("a"), b = Symbolic::variable("b"),
                 c = Symbolic::variable("cos_theta");
  for (const Symbolic& formula : {schlick_weight(c), fresnel_quadratic(c, a, b), gaussian_lobe(c, a, b),
                                  BlinnPhongBrdfLobe::constant(a), BlinnPhongLobe::constant(a)}) {
    EXPECT_EQ(to_text(parse(to_text(formula))), to_text(formula));
  }
}

// A definition is put into an integral, and the variable of the integral keeps its own meaning.
TEST(ReadFormula, ReadsBackIntegrals) {
  FormulaNames names{.variables = {"x", "t"}, .takes_integrals = true};
  const auto printed = [&](std::string_view text) { return to_text(read_formula(text, names).formula); };
  for (const std::string text :
       {"integral(x s, s, 0, x)", "2 integral(integral(x s u, u, 0, s), s, 0, 1)", "integral(s, s, 0, t)^2"})
    EXPECT_EQ(printed(text), text);
  names.definitions = {{"g", {{"y"}, parse_formula("y + 1", std::array<std::string_view, 1>{"y"})}}};
  EXPECT_EQ(printed("integral(g(s x), s, 0, g(t))"), "integral(s x + 1, s, 0, t + 1)");
  names.definitions = {
      {"h",
       {{"y"},
        read_formula("integral(y s, s, 0, 1)", {.variables = {"y"}, .takes_integrals = true}).formula}}};
  EXPECT_EQ(printed("integral(h(s), s, 0, 1)"), "integral(integral(s s_, s_, 0, 1), s, 0, 1)");
}

// The same value in 50 digits, term by term: reading does not rearrange.
TEST(ParseFormula, TheReadingHasTheSameValue) {
  const auto value = [](const Symbolic& e) {
    return evaluate<Decimal50>(e, [](const std::string& name) { return Decimal50(name == "a" ? 3 : 0.5); });
  };
  const Symbolic a = Symbolic::variable("a");
  for (const Symbolic& formula : {BlinnPhongBrdfLobe::constant(a), BlinnPhongLobe::constant(a),
                                  PhongLobe::constant(a), BlinnPhongCheapLobe::constant(a)}) {
    EXPECT_EQ(value(parse(to_text(formula))), value(formula));
  }
}

/// "1 + c + c ..": as many operations inside one another as it has terms after the first.
std::string sum_of(std::size_t terms) {
  std::string text = "1";
  for (std::size_t i = 0; i < terms; ++i) text += "+a";
  return text;
}

// Functions on formulas are recursive, so length and depth have limits.
TEST(ParseFormula, LengthAndDepthHaveAnEnd) {
  EXPECT_EQ(parse(sum_of(deepest_formula)).depth(), deepest_formula);
  EXPECT_NE(
      error_of(sum_of(deepest_formula + 1)).find("expected no more than 200 operations inside one another"),
      std::string::npos);
  EXPECT_EQ(error_of(std::string(longest_formula - 1, ' ') + "a"), "");
  EXPECT_EQ(error_of(std::string(longest_formula, ' ') + "a"),
            "the formula is 4001 characters long: at most 4000");
  EXPECT_EQ(error_of(sum_of(500000)), "the formula is 1000001 characters long: at most 4000");
  // Every way to nest: none gets deeper than the limit.
  const auto nested = [](const std::string& before, const std::string& after, std::size_t times) {
    std::string text = "a";
    for (std::size_t i = 0; i < times; ++i) text = before + text + after;
    return text;
  };
  for (const auto& [before, after] :
       {std::pair("(", ")"), std::pair("-(", ")"), std::pair("exp(", ")"), std::pair("a*(", ")"),
        std::pair("2^(", ")"), std::pair("max(a,", ")"), std::pair("1/(", ")"), std::pair("(a<", "?a:a)")}) {
    std::string text = nested(before, after, 98);
    ASSERT_LE(text.size(), longest_formula);
    EXPECT_LE(parse(text).depth(), deepest_formula) << text;
    EXPECT_NE(error_of(nested(before, after, 120)), "") << before;
  }
}

TEST(ParseFormula, ReadsEveryPrintedConstant) {
  const auto value = [](std::string_view text, double alpha) {
    constexpr std::array<std::string_view, 1> names{"a"};
    return evaluate<double>(parse_formula(text, names), [&](const std::string&) { return alpha; });
  };
  const auto check = [&]<class Lobe>(const Lobe&) {
    for (const double alpha : {0.1, 1.0, 8.0, 2048.0})
      EXPECT_NEAR(value(Lobe::record.printed, alpha) / Lobe::constant(alpha), 1, 1e-15) << Lobe::record.id;
  };
  std::apply([&](const auto&... lobe) { (check(lobe), ...); }, NormalisedLobes{});
}

}  // namespace
}  // namespace shadefit
