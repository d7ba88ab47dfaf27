#include "fit/scalars/symbolic.hpp"

#include <gtest/gtest.h>

#include "approx/fresnel.hpp"
#include "approx/lobe.hpp"
#include "approx/phong_blinn.hpp"

// A namespace of its own: the letters below would hide those of the files that are compiled with this one.
namespace shadefit::symbolic_test {
namespace {

Symbolic v(const char* name) {
  return Symbolic::variable(name);
}

const Symbolic a = v("a"), b = v("b"), c = v("c"), k = v("k"), x = v("x");

TEST(Symbolic, FormulasPrintThemselves) {
  EXPECT_EQ(to_text(schlick_weight(c)), "(1 - c)^5");
  EXPECT_EQ(to_text(fresnel_quadratic(c, a, b)), "exp2((a c + b) c)");
  EXPECT_EQ(to_text(fresnel_one_term(c, v("A"))), "exp2(-A c)");
  EXPECT_EQ(to_text(power_lobe(c, k)), "c^k");
  EXPECT_EQ(to_text(gaussian_lobe(c, k, x)), "exp((k + x) (c - 1))");
  EXPECT_EQ(to_text(blinn_lobe_of_cosine(c, k, x)), "((1 + c)/2)^(x k/2)");
  EXPECT_EQ(to_text(schlick_reflectance(v("f0"), v("w"))), "f0 + (1 - f0) w");
  EXPECT_EQ(to_text((integer<Symbolic>(5) + x) / ln2<Symbolic>()), "(5 + x)/ln2");
  EXPECT_EQ(to_text(positive_part(c - k)), "max(c - k, 0)");
}

TEST(Symbolic, FormulasPrintThemselvesInLatex) {
  EXPECT_EQ(to_latex(schlick_weight(c)), R"(\left(1 - c\right)^{5})");
  EXPECT_EQ(to_latex(fresnel_quadratic(c, a, b)), R"(2^{\left(a c + b\right) c})");
  EXPECT_EQ(to_latex(gaussian_lobe(c, k, x)), R"(e^{\left(k + x\right) \left(c - 1\right)})");
  EXPECT_EQ(to_latex(blinn_lobe_of_cosine(c, k, x)), R"(\left(\frac{1 + c}{2}\right)^{\frac{x k}{2}})");
  EXPECT_EQ(to_latex((integer<Symbolic>(5) + v("alpha")) / ln2<Symbolic>()), R"(\frac{5 + \alpha}{\ln 2})");
  EXPECT_EQ(to_latex(reflectance_at_normal(v("n1"))), R"(\left(\frac{n_{1} - 1}{n_{1} + 1}\right)^{2})");
  EXPECT_EQ(to_latex(sqrt(v("cos_theta"))), R"(\sqrt{\mathrm{cos\_theta}})");
  EXPECT_EQ(to_latex(v("theta_v") * v("F_i")), R"(\theta_{v} F_{i})");
  EXPECT_EQ(to_latex(v("c_diff") * v("Lambda")), R"(c_{\mathrm{diff}} \Lambda)");
  EXPECT_EQ(to_latex(atan(v("x"))), R"(\arctan\left(x\right))");
  EXPECT_EQ(to_latex(erfc(x)), R"(\operatorname{erfc}\left(x\right))");
  EXPECT_EQ(to_latex(log1p_remainder(x)), R"(\ln\left(1 + x\right) - \left(x\right))");
}

TEST(Symbolic, ParenthesesStandWhereTheyAreNeeded) {
  EXPECT_EQ(to_text((a + b) + c), "a + b + c");
  EXPECT_EQ(to_text(a + (b + c)), "a + (b + c)") << "sums are not associative in floating point";
  EXPECT_EQ(to_text(a - (b - c)), "a - (b - c)");
  EXPECT_EQ(to_text(a - b * c), "a - b c");
  EXPECT_EQ(to_text(-(a + b)), "-(a + b)");
  EXPECT_EQ(to_text(a + -b), "a + (-b)");
  EXPECT_EQ(to_text(a * -b), "a (-b)");
  EXPECT_EQ(to_text(a * (b * c)), "a (b c)");
  EXPECT_EQ(to_text(a / (b * c)), "a/(b c)");
  EXPECT_EQ(to_text(a / b / c), "(a/b)/c");
  EXPECT_EQ(to_text(a / b * c), "(a/b) c");
  EXPECT_EQ(to_text(a * integer<Symbolic>(2)), "a * 2");
  EXPECT_EQ(to_text(power(power(a, b), c)), "(a^b)^c");
  EXPECT_EQ(to_text(power(-a, 2)), "(-a)^2");
  EXPECT_EQ(to_text(constant<Symbolic>("-0.5") * a), "(-0.5) a");
  EXPECT_EQ(to_text(select(less(a, b), c, k)), "(a < b ? c : k)");
  EXPECT_EQ(to_latex(select(less(a, b), c, k)),
            R"(\begin{cases}c & a < b \\ k & \text{otherwise}\end{cases})");
}

// Lagarde 2012 counts the instructions of the forms by hand.
TEST(Operations, AreThoseThatThePostCounts) {
  EXPECT_EQ(to_text(count_operations(fresnel_quadratic(c, a, b))), "MAD, MUL, EXP2");
  EXPECT_EQ(to_text(count_operations(fresnel_one_term(c, v("A")))), "MUL, EXP2");
  EXPECT_EQ(to_text(count_operations(schlick_weight(c))), "ADD, 3 MUL") << "by squaring";
  EXPECT_EQ(to_text(count_operations(power(integer<Symbolic>(1) - c, constant<Symbolic>("5")))),
            "ADD, MUL, LOG2, EXP2");
  EXPECT_EQ(to_text(count_operations(exp2(a * c - a))), "MAD, EXP2");
  EXPECT_EQ(count_operations(power(c, k)).total(), 3) << "pow";
}

TEST(Operations, EqualPartsAreComputedOnceAndNumbersBeforehand) {
  EXPECT_EQ(count_operations((a + b) * (a + b)), (Operations{.add = 1, .multiply = 1}));
  EXPECT_EQ(count_operations(a * b + a * b), (Operations{.add = 1, .multiply = 1}))
      << "a product used twice stays one";
  EXPECT_EQ(count_operations(a * b - c * k), (Operations{.multiply = 1, .multiply_add = 1}));
  EXPECT_EQ(count_operations(-a), Operations{}) << "a sign is free";
  EXPECT_EQ(count_operations(pi<Symbolic>() * integer<Symbolic>(2)), Operations{});
  EXPECT_EQ(count_operations(a / integer<Symbolic>(2)), Operations{.multiply = 1});
  EXPECT_EQ(count_operations(a / b), Operations{.divide = 1});
  EXPECT_EQ(count_operations(exp(a)), (Operations{.multiply = 1, .exp2 = 1}));
  EXPECT_EQ(count_operations(exp(constant<Symbolic>("2.5") * a)), (Operations{.multiply = 1, .exp2 = 1}));
  EXPECT_EQ(count_operations(log(a)), (Operations{.multiply = 1, .log2 = 1}));
  EXPECT_EQ(count_operations(power(a, 1)), Operations{});
  EXPECT_EQ(count_operations(power(a, 4)), Operations{.multiply = 2});
  EXPECT_EQ(count_operations(power(a, -4)), (Operations{.multiply = 2, .divide = 1}));
  EXPECT_EQ(count_operations(select(less(a, b), a, b)), Operations{.other = 2});
  EXPECT_EQ(to_text(Operations{}), "nothing");
}

const InstructionSet dot_products{.dot_products = true};

TEST(Operations, DotProductsAreOneInstructionWhereAProcessorHasThem) {
  const auto sum = a * b + c * k + a * x;
  EXPECT_EQ(count_operations(sum, dot_products), Operations{.dot3 = 1});
  EXPECT_EQ(count_operations(sum + c * x, dot_products), Operations{.dot4 = 1});
  EXPECT_EQ(count_operations(sum - k, dot_products), Operations{.dot4 = 1}) << "a term is a product with 1";
  EXPECT_EQ(count_operations(sum + c * x), (Operations{.multiply = 1, .multiply_add = 3}))
      << "only where asked";
  EXPECT_EQ(to_text(count_operations(exp2(sum - k), dot_products)), "DOT4, EXP2");
}

TEST(Operations, OnlyWholeSumsOfThreeProductsAreDotProducts) {
  const auto two = a * b + c * k;
  EXPECT_EQ(count_operations(two, dot_products), count_operations(two));
  EXPECT_EQ(count_operations(two + a, dot_products), count_operations(two + a));
  EXPECT_EQ(count_operations(two + a + b, dot_products), count_operations(two + a + b));
  const auto three = two + a * x;
  EXPECT_EQ(count_operations((three + c * x) + b, dot_products), (Operations{.add = 1, .dot4 = 1}))
      << "a fifth term is one more instruction";
  EXPECT_EQ(count_operations(two * (two + a * x), dot_products),
            (Operations{.multiply = 2, .multiply_add = 2}))
      << "a sum that is used twice is not part of another";
}

TEST(Operations, AScaleOfAResultIsFreeWhereAProcessorHasIt) {
  const InstructionSet scaling{.free_scales = {4, 0.5}};
  const auto four = integer<Symbolic>(4), two = integer<Symbolic>(2);
  EXPECT_EQ(count_operations(exp2(log2(a) * four), scaling), (Operations{.exp2 = 1, .log2 = 1}));
  EXPECT_EQ(count_operations(exp2(log2(a) * four)), (Operations{.multiply = 1, .exp2 = 1, .log2 = 1}));
  EXPECT_EQ(count_operations(exp2(log2(a) * two), scaling), (Operations{.multiply = 1, .exp2 = 1, .log2 = 1}))
      << "2 is not one of them";
  EXPECT_EQ(count_operations(log2(a) / two, scaling), Operations{.log2 = 1}) << "1/2 is";
  EXPECT_EQ(count_operations(a * four, scaling), Operations{.multiply = 1}) << "a variable is no result";
  EXPECT_EQ(count_operations(log2(a) * four + log2(a), scaling), (Operations{.multiply_add = 1, .log2 = 1}))
      << "the result is used unscaled too";
  EXPECT_EQ(count_operations(log2(a) * four + b, scaling), (Operations{.add = 1, .log2 = 1}));
}

TEST(Operations, OfSeveralResultsShareWhatIsEqual) {
  const std::vector<Symbolic> results{exp2(a * b), exp2(a * b + c)};
  EXPECT_EQ(count_operations(results), (Operations{.add = 1, .multiply = 1, .exp2 = 2}));
  EXPECT_EQ(count_operations(results) - count_operations(results.front()), (Operations{.add = 1, .exp2 = 1}));
  EXPECT_EQ(count_operations(std::span<const Symbolic>{}), Operations{});
}

TEST(Symbolic, EvaluatesWithItsVariables) {
  const auto value_of = [](const std::string& name) { return name == "a" ? 3.0 : 4.0; };
  EXPECT_EQ(evaluate<double>(sqrt(a * a + b * b), value_of), 5);
  EXPECT_EQ(evaluate<double>(select(less(a, b), -a, b), value_of), -3);
  EXPECT_EQ(evaluate<double>(power(a, 3), value_of), 27);
  EXPECT_THROW(evaluate<double>(Symbolic::function("gamma", {a}), value_of), std::logic_error);
}

}  // namespace
}  // namespace shadefit::symbolic_test
