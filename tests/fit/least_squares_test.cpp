#include "fit/least_squares.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "fit/families.hpp"
#include "fit/fit.hpp"
#include "tests/accuracy.hpp"
#include "tests/references.hpp"

namespace shadefit {
namespace {

using testing::is_close;

Measure measure_of(const std::string& text) {
  return text == "angle" ? Measure::angle : Measure::cosine;
}

// The promise: 14 correct digits for every exponent in 0.1 .. 1e6, whole or not.
constexpr double promised = 1e-14;

TEST(LeastSquares, HasFourteenDigitsOfEveryReference) {
  const auto references = testing::read_references();
  EXPECT_EQ(references.size(), 86U);
  for (const auto& reference : references) {
    const FittableFamily& family = *find_family(reference.constant);
    const Fit fit = family.fit(reference.exponent.value_or(0), {.measure = measure_of(reference.measure)});
    const auto i = std::find(family.parameters.begin(), family.parameters.end(), reference.parameter) -
                   family.parameters.begin();
    EXPECT_EQ(fit.status, Status::converged) << reference.describe();
    EXPECT_EQ(fit.digits, 14) << reference.describe();
    EXPECT_TRUE(is_close(reference.describe(), reference.value, fit.parameters[static_cast<std::size_t>(i)],
                         promised));
  }
}

TEST(LeastSquares, MeanOverThreeToFifteen) {
  // Reference: the mean of the stored 50-digit values.
  Decimal50 expected = 0, computed = 0;
  for (const auto& reference : testing::read_references()) {
    const bool is_in = reference.constant == "sg-offset" && reference.measure == "cosine" &&
                       *reference.exponent >= 3 && *reference.exponent <= 15 &&
                       std::floor(*reference.exponent) == *reference.exponent;
    if (!is_in) continue;
    expected += reference.value / 13;
    computed += Decimal50(find_family("sg-offset")->fit(*reference.exponent, {}).parameters[0]) / 13;
  }
  EXPECT_TRUE(is_close("mean", Decimal50("0.775364258522491148"), expected, 1e-17));
  EXPECT_TRUE(is_close("mean", expected, computed, promised));
}

// (1-c)^5 is c^5 seen from the other end, so in the cosine measure the two problems are one.
TEST(LeastSquares, OneTermIsTheOffsetAtExponentFive) {
  const double x = find_family("sg-offset")->fit(5, {}).parameters[0];
  const double a = find_family("fresnel-one-term")->fit(0, {}).parameters[0];
  EXPECT_TRUE(is_close("A", one_term_sharpness(Decimal50(x)), a, promised));
  const double x_angle = find_family("sg-offset")->fit(5, {.measure = Measure::angle}).parameters[0];
  const double a_angle = find_family("fresnel-one-term")->fit(0, {.measure = Measure::angle}).parameters[0];
  EXPECT_FALSE(is_close("A", one_term_sharpness(Decimal50(x_angle)), a_angle, 1e-3))
      << "the angle tells the ends apart";
}

TEST(LeastSquares, ApproachesTheDerivedLaw) {
  for (const Measure measure : measures) {
    const auto expansion = peak_expansion(measure);
    const auto law = offset_law(expansion.p, expansion.w);
    for (const double k : {1e4, 1e5, 1e6, 1e9}) {
      const double x = find_family("sg-offset")->fit(k, {.measure = measure}).parameters[0];
      // The next term is of order 1/k^2 with a coefficient below 1; 2e-16 is the rounding of x.
      EXPECT_NEAR(x, law.limit + law.slope / k, 1 / (k * k) + 2e-16) << name(measure) << " " << k;
    }
  }
}

TEST(LeastSquares, AnyPositiveExponentConvergesFarBeyondThePromise) {
  for (const double k : {1e-12, 1e-6, 1e-3, 0.05, 1e7, 1e9, 1e12}) {
    for (const Measure measure : measures) {
      const Fit fit = find_family("sg-offset")->fit(k, {.measure = measure});
      EXPECT_EQ(fit.status, Status::converged) << k << " " << name(measure);
      EXPECT_GT(fit.parameters[0], 0);
      EXPECT_LT(fit.parameters[0], 1) << "Lagarde 2012: the optimum lies between 0 and 1";
    }
  }
}

TEST(LeastSquares, SaysSoWhenItFails) {
  // At k = 1e160 the square of 1/k has no double: nothing can be fitted, and no start may pass for an answer.
  const Fit fit = find_family("sg-offset")->fit(1e160, {});
  EXPECT_NE(fit.status, Status::converged);
  EXPECT_EQ(fit.digits, 0);
}

/// A family whose error does not depend on its parameter: every start is stationary, none an answer.
struct Flat : SgOffset {
  template <class T, class P>
  P error(const Sample<T>& s, const std::array<P, 1>&) const {
    return lift<P>(s.one_minus_cos);
  }
};

/// A family with two equal minima, p = -1 and p = 1.
struct TwoMinima : SgOffset {
  static std::array<std::array<double, 1>, 3> starts() { return {{{-2}, {0.5}, {2}}}; }
  template <class T, class P>
  P error(const Sample<T>&, const std::array<P, 1>& p) const {
    return p[0] * p[0] - integer<P>(1);
  }
};

/// A family that is not a number anywhere.
struct NotFinite : SgOffset {
  template <class T, class P>
  P error(const Sample<T>&, const std::array<P, 1>& p) const {
    return log(-(p[0] * p[0]) - integer<P>(1));
  }
};

TEST(LeastSquares, FlatTwofoldAndInfiniteProblemsAreNotConverged) {
  EXPECT_EQ(solve_least_squares(Flat{{1}}, Metric{}).status, Status::ambiguous);
  EXPECT_EQ(solve_least_squares(TwoMinima{{1}}, Metric{}).status, Status::ambiguous);
  EXPECT_NE(solve_least_squares(NotFinite{{1}}, Metric{}).status, Status::converged);
}

/// A maximum or saddle has a zero gradient too: error = cos(p), whose square is largest at p = 0.
struct AtMaximum : SgOffset {
  static std::array<std::array<double, 1>, 3> starts() { return {{{0}, {0}, {0}}}; }
  template <class T, class P>
  P error(const Sample<T>&, const std::array<P, 1>& p) const {
    return cos(p[0]);
  }
};

TEST(LeastSquares, AMaximumIsNotAnAnswer) {
  EXPECT_NE(solve_least_squares(AtMaximum{{1}}, Metric{}).status, Status::converged);
}

// The stated digits are honest: never more than the reference shows.
TEST(LeastSquares, DigitsDoNotOverstate) {
  for (const auto& reference : testing::read_references()) {
    const FittableFamily& family = *find_family(reference.constant);
    const Fit fit = family.fit(reference.exponent.value_or(0), {.measure = measure_of(reference.measure)});
    const auto i = std::find(family.parameters.begin(), family.parameters.end(), reference.parameter) -
                   family.parameters.begin();
    const Decimal50 error = abs(Decimal50(fit.parameters[static_cast<std::size_t>(i)]) / reference.value - 1);
    EXPECT_LE(error, pow(Decimal50(10), -fit.digits)) << reference.describe();
  }
}

// Gradient and Hessian by Jets of Jets against central differences of the summed square itself, in long
// double.
TEST(SampledProblem, DerivativesAreThoseOfTheSquare) {
  const FresnelQuadratic family;
  const SampledProblem<FresnelQuadratic, long double> problem(family, Substitution({}, family.shape()), 1);
  const std::array<long double, 2> p{-5.0L, -7.5L};
  const auto d = problem.derivatives(p);
  constexpr long double h = 1e-4L;
  for (std::size_t i = 0; i < 2; ++i) {
    auto up = p, down = p;
    up[i] += h, down[i] -= h;
    const auto above = problem.derivatives(up), below = problem.derivatives(down);
    const auto row = static_cast<int>(i);
    // the differences are off by h^2 times a third derivative of the size of the second: 1e-8
    EXPECT_NEAR(static_cast<double>((above.square - below.square) / (4 * h) / d.gradient[row]), 1, 1e-7);
    for (int j = 0; j < 2; ++j) {
      EXPECT_NEAR(static_cast<double>((above.gradient[j] - below.gradient[j]) / (2 * h) / d.hessian(row, j)),
                  1, 1e-7);
    }
  }
  EXPECT_EQ(d.hessian(0, 1), d.hessian(1, 0));
}

TEST(Status, HasNames) {
  EXPECT_EQ(name(Status::converged), "converged");
  EXPECT_EQ(name(Status::ambiguous), "ambiguous");
  EXPECT_EQ(name(Status::not_converged), "not-converged");
  EXPECT_EQ(name(Status::not_finite), "not-finite");
}

}  // namespace
}  // namespace shadefit
