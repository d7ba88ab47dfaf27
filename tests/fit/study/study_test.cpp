#include "fit/study/study.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

#include "fit/catalogue/family.hpp"
#include "fit/exchange/minimax_study.hpp"
#include "fit/squares/solve_study.hpp"
#include "fit/support/format.hpp"
#include "fit/support/user_error.hpp"
#include "tests/refusal.hpp"

namespace shadefit {
namespace {

StudyFit fit_of(const Study& study) {
  return solve_study(read_study(study), study.starts);
}

std::string fault_of(const Study& study) {
  return testing::refusal([&] { fit_of(study); });
}

/// A form of x in [0, 1].
Study on_unit(const std::string& target, const std::string& form) {
  return {.target = target, .form = form, .over = {{"x", "0", "1"}}};
}

/// A study whose answer is known.
struct KnownStudy {
  const char* name;
  Study study;
  std::vector<double> parameters;
  /// The digits of `parameters` as they stand here: those of a closed form are all right.
  double tolerance = 4 * std::numeric_limits<double>::epsilon();
};

std::vector<KnownStudy> known_studies() {
  constexpr double fifteen_digits = 1e-14;
  return {
      {"the arc cosine by a line times a root",
       on_unit("acos(x)", "sqrt(1-x) (a + b x)"),
       {1.56515463601461, -0.163889932843928},
       fifteen_digits},
      {"Henyey-Greenstein by Schlick's phase function, g = 0.5",
       {.target = "hg(c, g)",
        .form = "(1 - k^2)/(4 pi (1 - k c)^2)",
        .over = {{"c", "-1", "1"}},
        .definitions = {{"hg", {"c", "g"}, "(1 - g^2)/(4 pi pow(1 + g^2 - 2 g c, 1.5))"}},
        .given = {{"g", "0.5"}}},
       {0.700785835998294},
       fifteen_digits},
      // Closed forms: the normal equations of a line on [0, 1] with the moments of the target.
      {"a root at an end", on_unit("sqrt(x)", "a + b x"), {4.0 / 15, 0.8}},
      {"a logarithm at an end", on_unit("log(x)", "a + b x"), {-2.5, 3}},
      {"a kink", on_unit("max(x - 1/4, 0)", "a + b x"), {-9.0 / 64, 27.0 / 32}},
      // The first two coefficients of the Chebyshev series of e^x: I0(1) and 2 I1(1) (Abramowitz, Stegun
      // 1964, "Handbook of Mathematical Functions", 9.6.34 and table 9.8).
      {"the density of Chebyshev polynomials",
       {.target = "exp(x)", .form = "a + b x", .over = {{"x", "-1", "1", "1/sqrt((1 - x) (1 + x))"}}},
       {1.2660658777520083, 1.1303182079849700}},
      {"two variables",
       {.target = "x y", .form = "a + b x + d y", .over = {{"x", "0", "1"}, {"y", "0", "1"}}},
       {-0.25, 0.5, 0.5}},
      // E max(x, y) = 2/3, E x max = 3/8 and E x = 1/2, E x^2 = 1/3, E x y = 1/4 on the square.
      {"a kink across two variables",
       {.target = "max(x, y)", .form = "a + b (x + y)", .over = {{"x", "0", "1"}, {"y", "0", "1"}}},
       {1.0 / 6, 0.5}},
      {"three variables",
       {.target = "x y z",
        .form = "a + b (x + y + z)",
        .over = {{"x", "0", "1"}, {"y", "0", "1"}, {"z", "0", "1"}}},
       {-0.25, 0.25},
       4e-15},
      {"a sum of exponentials, found in a canonical order",
       {.target = "2 exp(-3 x) + 0.5 exp(-x)",
        .form = "a exp(-b x) + d exp(-g x)",
        .over = {{"x", "0", "2"}}},
       {0.5, 1, 2, 3},
       1e-12},
      {"an even form: the parameter that is not negative", on_unit("cos(2 x)", "cos(a x)"), {2}, 1e-14},
      {"a choice in the target", on_unit("x <= 0.5 ? 0 : 1", "a + b x"), {-0.25, 1.5}},
      {"an integral up to the variable",
       on_unit("integral(sin(t), t, 0, x)", "a + b cos(x)"),
       {1, -1},
       1e-14},
      {"an integral of the form, with a parameter",
       on_unit("(1 - exp(-2 x))/2", "integral(exp(-a t), t, 0, x)"),
       {2},
       1e-14},
      // The integral of sqrt(x t) over t is 2/3 sqrt(x).
      {"a root at an end of the integral",
       on_unit("3/2 * integral(sqrt(x t), t, 0, 1)", "a + b x"),
       {4.0 / 15, 0.8},
       1e-14},
      {"integrals inside one another, by a definition with the same name",
       {.target = "integral(f(t) t, t, 0, 1)",
        .form = "a + b x",
        .over = {{"x", "0", "1"}},
        .definitions = {{"f", {"y"}, "integral((1 + x y) s, s, 0, 2)"}}},
       {1, 2.0 / 3},
       1e-14},
      {"a relative error: the mean of (a/x - 1)^2 on [1, 2]",
       {.target = "x", .form = "a", .over = {{"x", "1", "2"}}, .error = Error::relative},
       {2 * std::log(2)}},
      {"a weight: the mean of x^2 (a - x)^2",
       {.target = "x", .form = "a", .over = {{"x", "0", "1"}}, .weight = "x"},
       {0.75}},
  };
}

TEST(Study, FindsWhatIsKnown) {
  for (const KnownStudy& known : known_studies()) {
    const StudyFit fit = fit_of(known.study);
    EXPECT_EQ(name(fit.status), "converged") << known.name << ": " << fit.why;
    EXPECT_GE(fit.digits, 13) << known.name;
    ASSERT_EQ(fit.parameters.size(), known.parameters.size()) << known.name;
    for (std::size_t i = 0; i < known.parameters.size(); ++i) {
      EXPECT_NEAR(fit.parameters[i] / known.parameters[i], 1, known.tolerance)
          << known.name << ", " << fit.names[i] << ": expected " << to_text(known.parameters[i])
          << ", computed " << to_text(fit.parameters[i]);
    }
  }
}

/// A built-in family as a study.
Study study_of(const Family& family, double exponent) {
  const auto text = [&](const Symbolic& formula) { return to_text(formula); };
  Study study{.target = text(family.target), .form = text(family.form), .over = {{"c", "0", "1"}}};
  if (family.has_exponent()) study.given = {{"k", to_text(exponent)}};
  return study;
}

/// The exponents at which a family is compared.
std::vector<double> exponents_of(const Family& family, const std::vector<double>& exponents) {
  return family.has_exponent() ? exponents : std::vector<double>{0};
}

// A descent finds a frequency only from near it. sin(12 x) by b sin(a x) gave -13.5 from the fixed starts.
// Frequencies of up to 40 that are right have 14 digits; another basin is off by more than 0.1.
TEST(Study, FrequenciesAreFoundInTheTarget) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> frequency(4, 40), amplitude(0.3, 2), rate(0, 1);
  for (int i = 0; i < 20; ++i) {
    const auto number = [](double value) { return fmt::format("{:.3f}", value); };
    const std::string a = number(frequency(random)), k = number(rate(random)), b = number(amplitude(random));
    const Study wave{.target = b + " sin(" + a + " x)", .form = "b sin(a x)", .over = {{"x", "0", "3"}}};
    const Study damped{.target = b + " exp(-" + k + " x) sin(2 pi (" + a + "*x/5 + 0.3))",
                       .form = "exp(-k x) (b sin(2 pi a x) + d cos(2 pi a x))",
                       .over = {{"x", "0", "2"}}};
    const StudyFit first = fit_of(wave), second = fit_of(damped);
    EXPECT_NEAR(std::abs(first.parameters[1]), std::stod(a), 1e-9) << wave.target;
    const auto at = std::ranges::find(second.names, "a") - second.names.begin();
    EXPECT_NEAR(std::abs(second.parameters[static_cast<std::size_t>(at)]), std::stod(a) / 5, 1e-9)
        << damped.target;
  }
}

StudyFit fit_of(const Study& study, Norm norm) {
  return norm == Norm::minimax ? solve_minimax_study(read_study(study), {}, {}) : fit_of(study);
}

/// Compares what both say with the digits that both claim: each may be wrong by one of the last.
void expect_same(const Family& family, double exponent, const Fit& expected, const StudyFit& fit) {
  const int digits = std::min(fit.digits, expected.digits);
  for (std::size_t i = 0; i < fit.names.size(); ++i) {
    const double value = expected.parameters[parameter_index(family, fit.names[i])];
    EXPECT_NEAR(fit.parameters[i] / value, 1, 2 * std::pow(10.0, -digits))
        << family.id << " at " << to_text(exponent) << ", " << fit.names[i] << ": expected " << to_text(value)
        << ", computed " << to_text(fit.parameters[i]) << ", digits " << expected.digits << " and "
        << fit.digits;
  }
}

// A family's plain formulas, given as text over c, have the family's constants. Text knows no other variable
// for a lobe: where a sharp one loses digits, it says so, and all nodes may be where the lobe is 0.
TEST(Study, HasTheConstantsOfEveryFamily) {
  for (const Norm norm : {Norm::least_squares, Norm::minimax}) {
    for (const Family& family : families()) {
      for (const double exponent : exponents_of(family, {3, 7.5, 15, 100, 1000, 1e4, 1e5, 1e6, 1e8})) {
        const Fit expected = family.fit(Setting(exponent), Metric{.norm = norm});
        if (expected.status != Status::converged) continue;
        const StudyFit fit = fit_of(study_of(family, exponent), norm);
        const std::string what = family.id + " at " + to_text(exponent);
        if (exponent > 1000 && fit.status != Status::converged) continue;
        ASSERT_EQ(name(fit.status), "converged") << what << ": " << fit.why;
        expect_same(family, exponent, expected, fit);
        if (exponent > 1000) continue;
        // A lobe of exponent 1000 loses 3 digits: c^k amplifies the rounding of c.
        EXPECT_GE(fit.digits, 10) << what;
        EXPECT_NEAR(fit.rms_error / expected.rms_error, 1, 1e-9) << what;
        EXPECT_NEAR(fit.max_abs_error.magnitude / expected.max_abs_error.magnitude, 1, 1e-6) << what;
        if (expected.level) {
          EXPECT_NEAR(*fit.level / *expected.level, 1, 1e-12) << what;
        }
      }
    }
  }
}

// By Remez's exchange in 60 digits: the arc cosine, with its level; and the built-in families.
TEST(MinimaxStudy, FindsWhatIsKnown) {
  const Study acos_linear = on_unit("acos(x)", "sqrt(1-x) (a + b x)");
  const StudyFit fit = solve_minimax_study(read_study(acos_linear), {}, {});
  ASSERT_EQ(name(fit.status), "converged") << fit.why;
  EXPECT_GE(fit.digits, 13);
  EXPECT_NEAR(fit.parameters[0] / 1.56758936297942, 1, 1e-14);
  EXPECT_NEAR(fit.parameters[1] / -0.168258065374859, 1, 1e-14);
  EXPECT_NEAR(*fit.level / 0.00320696381547317, 1, 1e-14);
  ASSERT_EQ(fit.alternation.size(), 3u);
  EXPECT_LT(fit.alternation[0].at.cos_theta, fit.alternation[1].at.cos_theta);
  EXPECT_NEAR(fit.max_abs_error.magnitude / *fit.level, 1, 1e-9);
}

// The extrema of a symmetric error come in pairs, which move together; and what is odd has no part in it.
TEST(MinimaxStudy, KnowsSymmetry) {
  const auto fit = [](const char* target, const char* form, const char* lower, const char* upper) {
    const Study study{.target = target, .form = form, .over = {{"x", lower, upper}}};
    StudyFit found = solve_minimax_study(read_study(study), {}, {});
    EXPECT_EQ(name(found.status), "converged") << form << ": " << found.why;
    return found;
  };
  // The even polynomial on [-1, 1] is that on [0, 1].
  const StudyFit whole = fit("cos(x)", "a + b x^2 + d x^4", "-1", "1");
  const StudyFit half = fit("cos(x)", "a + b x^2 + d x^4", "0", "1");
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(whole.parameters[i] / half.parameters[i], 1, 1e-14);
  const StudyFit with_odd = fit("cos(x)", "a + b x^2 + g x + h x^3 + d x^4", "-1", "1");
  EXPECT_NEAR(*with_odd.level / *half.level, 1, 1e-12);
  EXPECT_EQ(with_odd.parameters[2], 0);
  // Chebyshev: x^3 - 3/4 x.
  const StudyFit cubic = fit("x^3", "a + b x + d x^2", "-1", "1");
  EXPECT_EQ(cubic.parameters[0], 0);
  EXPECT_NEAR(cubic.parameters[1], 0.75, 1e-15);
  EXPECT_EQ(cubic.parameters[2], 0);
  EXPECT_NEAR(*cubic.level, 0.25, 1e-15);
  // A kink in the middle.
  EXPECT_NEAR(*fit("abs(x)", "a + b x^2", "-1", "1").level, 0.125, 1e-15);
}

// Exact where a parameter has to become 0; and where the error is the rounding of 0, whatever the parameters.
TEST(MinimaxStudy, IsExactAtAZeroOfTheTarget) {
  const auto fit = [](const Study& study, double place) {
    return solve_minimax_study(read_study(study), {.exact_at = {place}}, {});
  };
  const StudyFit square = fit(on_unit("x^2", "a + b x"), 0);
  ASSERT_EQ(name(square.status), "converged") << square.why;
  EXPECT_EQ(square.parameters[0], 0);
  EXPECT_NEAR(square.parameters[1], 2 * std::sqrt(2.0) - 2, 1e-15);
  const StudyFit sine =
      fit({.target = "sin(pi x)", .form = "(1 - x) (a + b x)", .over = {{"x", "0.1", "1"}}}, 1);
  EXPECT_EQ(name(sine.status), "converged") << sine.why;
}

TEST(MinimaxStudy, KeepsItsConstraints) {
  const Study line = on_unit("exp(x)", "a + b x");
  const auto fit_under = [&](const Constraints& constraints) {
    return solve_minimax_study(read_study(line), constraints, {});
  };
  // Without constraints the slope is that of the chord, e - 1; below the target the line is a tangent.
  EXPECT_NEAR(fit_under({}).parameters[1], std::exp(1) - 1, 1e-14);
  EXPECT_NEAR(fit_under({.exact_at = {0}}).parameters[0], 1, 1e-14);
  const StudyFit below = fit_under({.one_sided = Side::below});
  ASSERT_EQ(name(below.status), "converged") << below.why;
  EXPECT_NEAR(below.parameters[1], std::exp(1) - 1, 1e-14);
  EXPECT_THROW(fit_under({.exact_at = {0.5}}), UserError);
}

TEST(Study, SaysWhatIsGlobalAndWhatIsNotDetermined) {
  EXPECT_TRUE(fit_of(on_unit("exp(x)", "a + b x")).is_global);
  const StudyFit searched = fit_of(on_unit("exp(x)", "a exp(b x)"));
  EXPECT_FALSE(searched.is_global);
  EXPECT_GT(searched.starts, 1);
  const StudyFit flat = fit_of(on_unit("exp(x)", "a b x"));
  EXPECT_EQ(name(flat.status), "degenerate");
  EXPECT_EQ(flat.why, "the curve stays the same while a, b change together");
  // |x| on [-1, 1] by exp(-(x - m)^2) has two optima, left and right.
  const StudyFit two = fit_of({.target = "abs(x)", .form = "exp(-4 (x - m)^2)", .over = {{"x", "-1", "1"}}});
  EXPECT_EQ(name(two.status), "ambiguous") << two.why;
  ASSERT_EQ(two.other.size(), 1u);
  EXPECT_NEAR(two.other[0], -two.parameters[0], 1e-5);
}

// Where the rules for an integral disagree, nothing is called right.
TEST(Study, KnowsWhatAnIntegralIsWorth) {
  const auto digits = [](const char* target) {
    const StudyFit fit = fit_of({.target = target, .form = "a + b x", .over = {{"x", "0", "1"}}});
    return fit.status == Status::converged ? fit.digits : 0;
  };
  EXPECT_GE(digits("integral(log(t) + x t, t, 0, 1)"), 13);
  EXPECT_LE(digits("integral(1/sqrt(t) + x t, t, 0, 1)"), 8);
  EXPECT_LE(digits("integral(abs(t - 0.3) + x t, t, 0, 1)"), 5);
}

// A list keeps other names out; the order stays that of the form, and a held parameter is not fitted.
TEST(Study, TakesAListOfParameters) {
  Study study = on_unit("acos(x)", "sqrt(1-x) (a + b x)");
  study.parameters = {"b", "a"};
  EXPECT_EQ(read_study(study).parameters, (std::vector<std::string>{"a", "b"}));
  study.held = {{"a", 1.5}};
  EXPECT_EQ(read_study(study).parameters, (std::vector<std::string>{"b"}));
}

TEST(Study, AnswersBadInputWithOneLine) {
  const Study good = on_unit("acos(x)", "sqrt(1-x) (a + b x)");
  EXPECT_EQ(fault_of(good), "");
  const auto refusal = [&]<class T>(T Study::*member, const std::type_identity_t<T>& value) {
    Study study = good;
    study.*member = value;
    return fault_of(study);
  };
  EXPECT_EQ(
      refusal(&Study::target, "acoss(x)"),
      "--target: formula 'acoss(x)': expected one of x, pi, ln2 and the functions, not 'acoss' (did you mean "
      "'acos'?) at place 1");
  EXPECT_EQ(refusal(&Study::form, "sqrt(1-x (a + b x)"),
            "--form: formula 'sqrt(1-x (a + b x)': expected ')' at place 19");
  EXPECT_EQ(
      refusal(&Study::target, "integral(x, x, 0, 1)"),
      "--target: formula 'integral(x, x, 0, 1)': expected a new name for the variable of the integral at "
      "place 13");
  EXPECT_EQ(refusal(&Study::target, "integral(t x, t, 0)"),
            "--target: formula 'integral(t x, t, 0)': expected ',' at place 19");
  EXPECT_EQ(refusal(&Study::form, "integral(t, t, 0, x) t"),
            "--form: formula 'integral(t, t, 0, x) t': expected 't' inside its integral alone at place 22");
  EXPECT_EQ(refusal(&Study::form, "sqrt(1-x)"), "--form 'sqrt(1-x)' has no parameter to fit");
  EXPECT_EQ(refusal(&Study::form, "a + (b - b) x"), "--form does not depend on its parameter 'b'");
  EXPECT_EQ(refusal(&Study::over, {}),
            "--form needs --over, a variable and its range: for example --over x=0:1");
  EXPECT_EQ(refusal(&Study::over, {{"x", "1", "0"}}),
            "--over 'x=1:0' is empty: its first end must be below its second");
  EXPECT_EQ(refusal(&Study::over, {{"x", "0", "1"}, {"x", "0", "1"}}), "--over 'x' is given a second time");
  EXPECT_EQ(refusal(&Study::over, {{"x", "0", "1"}, {"y", "0", "1"}, {"z", "0", "1"}, {"w", "0", "1"}}),
            "--over 'w': a study has at most three variables");
  EXPECT_EQ(refusal(&Study::over, {{"sqrt", "0", "1"}}), "--over 'sqrt' is already a function or a number");
  EXPECT_EQ(refusal(&Study::over, {{"y", "0", "1"}}).substr(0, 27), "--target: formula 'acos(x)'");
  EXPECT_EQ(refusal(&Study::over, {{"x", "0", "2"}}).substr(0, 40),
            "--target has no finite value at x = 1.00");
  EXPECT_EQ(refusal(&Study::over, {{"x", "0", "1", "x - 2"}}).substr(0, 59),
            "--over 'x': its density must be finite and not negative; at");
  EXPECT_EQ(refusal(&Study::held, {{"c", 1}}), "--fix 'c': the form has no such parameter");
  EXPECT_EQ(refusal(&Study::starts, {{"c", 1}}), "--start 'c': the form has no such free parameter");
  EXPECT_EQ(refusal(&Study::weight, "x - 1").substr(0, 49),
            "--weight is negative, or has no finite value, at ");
  const auto relative = [](const std::string& target, const std::string& form) {
    return fault_of({.target = target, .form = form, .over = {{"x", "0", "1"}}, .error = Error::relative});
  };
  EXPECT_EQ(relative("x^2", "sqrt(1-x) (a + b x)"),
            "--error 'relative' divides by the target, which is 0 at x = 0: leave that place out of --over");
  EXPECT_EQ(
      relative("x (x - 0.25)", "a x"),
      "--error 'relative' divides by the target, which is 0 at x = 0.25: leave that place out of --over");
  EXPECT_EQ(refusal(&Study::given, {{"x", "1"}}), "--given 'x' is a variable already");
  EXPECT_EQ(refusal(&Study::definitions, {{"g", {}, "h"}, {"h", {}, "g"}}),
            "--let 'g' is defined by itself: g, h, g");
  EXPECT_EQ(refusal(&Study::definitions,
                    {{"k", {}, "f(2)"}, {"f", {"x"}, "2g(x)"}, {"g", {"h"}, "h + f(h)"}, {"h", {}, "f"}}),
            "--let 'f' is defined by itself: f, g, f");
  EXPECT_EQ(refusal(&Study::definitions, {{"f", {}, "f + 1"}}), "--let 'f' is defined by itself: f, f");
  EXPECT_EQ(refusal(&Study::definitions, {{"g", {}, "h"}, {"h", {}, "2"}}).substr(0, 22),
            "--let 'g': formula 'h'")
      << "no ring";
  EXPECT_EQ(refusal(&Study::parameters, {"a", "b", "d"}), "--params 'd': the form has no such parameter");
  EXPECT_EQ(refusal(&Study::parameters, {"a"}),
            "--form: formula 'sqrt(1-x) (a + b x)': expected one of x, a, pi, ln2 and the functions, not 'b' "
            "at place 16");
  EXPECT_EQ(refusal(&Study::parameters, {"a", "a"}), "--params 'a' is given a second time");
  EXPECT_EQ(refusal(&Study::parameters, {"x"}), "--params 'x' names something else already");
  EXPECT_EQ(refusal(&Study::parameters, {"2"}),
            "--params '2' is not a name: a letter, then letters, digits and underscores");
  EXPECT_EQ(refusal(&Study::form, std::string(1000000, 'a')),
            "--form: the formula is 1000000 characters long: at most 4000");
  EXPECT_EQ(
      refusal(&Study::form, "a/(b^2 (x - 0.5))"),
      "--form has a pole, or no finite value, from every start: give another by --start, for example --start a=2");
}

}  // namespace
}  // namespace shadefit
