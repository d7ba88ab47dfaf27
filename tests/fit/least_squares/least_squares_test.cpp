#include "fit/least_squares/least_squares.hpp"
#include "fit/least_squares/newton.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <type_traits>
#include <vector>

#include "approx/records/optical_constants.hpp"
#include "fit/errors/exact_fresnel.hpp"
#include "fit/families/families.hpp"
#include "fit/fit.hpp"
#include "tests/accuracy.hpp"
#include "tests/references.hpp"

namespace shadefit {
namespace {

using testing::is_close;

// The promise: 14 correct digits for every exponent in 0.1 .. 1e6, whole or not.
constexpr double promised = 1e-14;

TEST(LeastSquares, HasFourteenDigitsOfEveryReference) {
  const auto references = testing::read_references();
  EXPECT_EQ(references.size(), 91U + 43U + 57U);
  for (const auto& reference : references) {
    const FittableFamily& family = *find_family(reference.constant);
    const Fit fit = family.fit(reference.exponent.value_or(0), reference.metric());
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
    const bool is_in = reference.constant == "sg-offset" && reference.metric() == Metric{} &&
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

TEST(LeastSquares, ApproachesTheDerivedLaws) {
  for (const Measure measure : measures) {
    const auto expansion = peak_expansion(measure);
    const auto law = offset_law(expansion.p, expansion.w);
    for (const double k : {1e4, 1e5, 1e6, 1e9}) {
      const double x = find_family("sg-offset")->fit(k, {.measure = measure}).parameters[0];
      // The next term is of order 1/k^2 with a coefficient below 1; 2e-16 is the rounding of x.
      EXPECT_NEAR(x, law.limit + law.slope / k, 1 / (k * k) + 2e-16) << name(measure) << " " << k;
      const auto factor = factor_law(expansion.p);
      const double blinn = find_family("phong-blinn")->fit(k, {.measure = measure}).parameters[0];
      EXPECT_NEAR(blinn, factor.limit + factor.slope / k, 1 / (k * k) + 1e-15) << name(measure) << " " << k;
    }
  }
}

// As k falls to 0 the lobe is 1 + k log c + .. and the Gaussian 1 - (k + x) y + ..: the best x/k is that of
// fitting log c + y by -(x/k) y, which is 5/4 for the cosine; for the angle 1.19526 as 30 digits of another
// program say.
TEST(LeastSquares, AnyPositiveExponentConvergesFarBeyondThePromise) {
  for (const double k : {1e-12, 1e-9, 1e-6}) {
    EXPECT_NEAR(find_family("sg-offset")->fit(k, {}).parameters[0] / k, 1.25, 2 * k + 1e-14) << k;
    EXPECT_NEAR(find_family("sg-offset")->fit(k, {.measure = Measure::angle}).parameters[0] / k,
                1.1952619909676797, 2 * k + 1e-14)
        << k;
  }
  for (const double k : {1e-12, 1e-6, 1e-3, 0.05, 1e7, 1e9, 1e12}) {
    for (const Measure measure : measures) {
      const Fit fit = find_family("sg-offset")->fit(k, {.measure = measure});
      EXPECT_EQ(fit.status, Status::converged) << k << " " << name(measure);
      EXPECT_EQ(fit.digits, 14) << k << " " << name(measure);
      EXPECT_LT(fit.parameters[0], 1) << "Lagarde 2012: the optimum lies between 0 and 1";
    }
  }
}

TEST(LeastSquares, SaysSoWhenItFails) {
  // At k = 1e160 the square of 1/k underflows: nothing can be fitted, and no start value may count as an
  // answer.
  const Fit fit = find_family("sg-offset")->fit(1e160, {});
  EXPECT_EQ(fit.status, Status::not_converged);
  EXPECT_EQ(fit.digits, 0);
}

// Reference: another method's 18 digits of the pair refitted to the exact dielectric of index 1.5.
TEST(LeastSquares, FitsTheExactDielectric) {
  const Fit fit = find_family("fresnel-quadratic")->fit({0, exact_surface(1.5)}, {});
  EXPECT_EQ(fit.status, Status::converged);
  EXPECT_TRUE(is_close("a", Decimal50("-0.352485440363659108"), fit.parameters[0], promised));
  EXPECT_TRUE(is_close("b", Decimal50("-8.38688185141008383"), fit.parameters[1], promised));
  EXPECT_NEAR(fit.max_abs_error.magnitude, 0.0053, 0.00005);
  EXPECT_EQ(fit.relative_to, "the exact F");
}

// Schlick's formula with f0 of a surface is the same curve with smaller errors.
TEST(LeastSquares, SchlicksFormulaOfASurfaceHasTheSameOptimum) {
  const Fit any = find_family("fresnel-quadratic")->fit({}, {});
  const Fit glass = find_family("fresnel-quadratic")->fit({0, schlick_surface(1.5)}, {});
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_TRUE(is_close("parameter", Decimal50(any.parameters[i]), glass.parameters[i], promised));
  EXPECT_NEAR(glass.max_abs_error.magnitude / any.max_abs_error.magnitude, 0.96, 1e-12) << "1 - f0";
  EXPECT_NEAR(glass.max_rel_error->magnitude, any.max_rel_error->magnitude, 1e-12) << "f0 = 0.04 too";
}

// References: another program's minimisation with 25 digits, the Hessian positive definite there. Aluminium
// reflects less towards grazing before it reflects more, so that its best curve falls within c = 0.02.
TEST(LeastSquares, FitsConductors) {
  struct Reference {
    double ior, extinction;
    const char *a, *b;
    double rms;
  };
  for (const auto& [ior, extinction, a, b, rms] :
       {Reference{1.5724, 7.7354, "-3103.67622402044", "-19.7530969447907", 0.0364889375},
        {1.0728, 6.7839, "-1756.57719789283", "-15.8779789221883", 0.0276989164},
        {0.6079, 5.3676, "-635.176037168687", "-11.6884380673845", 0.0170115929}}) {
    const Fit fit = find_family("fresnel-quadratic")->fit({0, exact_surface(ior, extinction)}, {});
    EXPECT_EQ(fit.status, Status::converged) << ior;
    EXPECT_EQ(fit.digits, 14) << ior;
    EXPECT_TRUE(is_close("a", Decimal50(a), fit.parameters[0], 1e-13));
    EXPECT_TRUE(is_close("b", Decimal50(b), fit.parameters[1], 1e-13));
    EXPECT_NEAR(fit.rms_error / rms, 1, 1e-8);
  }
  for (const OpticalConstants& metal : metals) {
    const Surface surface = exact_surface(constant<double>(metal.ior), constant<double>(metal.extinction));
    for (const Measure measure : measures) {
      for (const char* family : {"fresnel-one-term", "fresnel-quadratic"}) {
        EXPECT_EQ(find_family(family)->fit({0, surface}, {.measure = measure}).status, Status::converged)
            << family << " " << metal.material << " " << metal.wavelength << " " << name(measure);
      }
    }
  }
}

// The largest error from inside stands at the kink itself, on the side where the slope is infinite.
TEST(LeastSquares, ErrorsFromInsideAreTheLargest) {
  for (const double ior : {0.6667, 0.67, 0.75, 0.9}) {
    for (const char* id : {"fresnel-one-term", "fresnel-quadratic"}) {
      const FittableFamily& family = *find_family(id);
      const Fit fit = family.fit({0, exact_surface(ior)}, {});
      ASSERT_EQ(fit.status, Status::converged);
      const double f0 = reflectance_at_normal(ior);
      const double kink = std::sqrt((1 - ior) * (1 + ior));
      for (const double c : {kink, kink * (1 + 1e-12), kink / 2, 0.9, 0.0, 1.0}) {
        const double form = fit.parameters.size() == 1
                                ? fresnel_one_term(c, fit.parameters[0])
                                : fresnel_quadratic(c, fit.parameters[0], fit.parameters[1]);
        const double exact = dielectric_reflectance(c, ior);
        const double error = std::abs(schlick_reflectance(f0, form) - exact);
        EXPECT_LE(error, fit.max_abs_error.magnitude * (1 + 1e-9)) << id << " " << ior << " " << c;
        EXPECT_LE(error / exact, fit.max_rel_error->magnitude * (1 + 1e-9)) << id << " " << ior << " " << c;
      }
    }
  }
}

// From inside everything beyond the critical angle is reflected: the kink is a joint of two panels.
TEST(LeastSquares, FitsTheExactDielectricFromInside) {
  for (const Measure measure : measures) {
    for (const double ior : {1 / 1.33, 1 / 1.5, 0.5}) {
      for (const char* family : {"fresnel-one-term", "fresnel-quadratic"}) {
        const Fit fit = find_family(family)->fit({0, exact_surface(ior)}, {.measure = measure});
        EXPECT_EQ(fit.status, Status::converged) << family << " " << ior << " " << name(measure);
        EXPECT_EQ(fit.digits, 14) << family << " " << ior << " " << name(measure);
      }
    }
  }
}

// From the starts, steps of Levenberg and Marquardt go down a long curved valley: two fifths of these did not
// converge. Each expected value is the best that another program found from sixty random starts.
TEST(LeastSquares, CubicsAndQuarticsFitEveryDielectric) {
  for (const Measure measure : measures) {
    for (const double ior :
         {0.3, 0.4, 0.5, 0.6, 0.667, 0.75, 0.9, 1.05, 1.1, 1.2, 1.33, 1.5, 1.7, 2.0, 2.4, 3.0, 3.5, 4.0}) {
      const Fit quadratic =
          find_family("fresnel-quadratic")->fit({0, exact_surface(ior)}, {.measure = measure});
      double last = quadratic.rms_error;
      for (const char* id : {"fresnel-cubic", "fresnel-quartic"}) {
        const Fit fit = find_family(id)->fit({0, exact_surface(ior)}, {.measure = measure});
        EXPECT_EQ(fit.status, Status::converged)
            << id << " " << ior << " " << name(measure) << " " << fit.why;
        EXPECT_EQ(fit.digits, 14) << id << " " << ior << " " << name(measure);
        EXPECT_LT(fit.rms_error, last)
            << id << " " << ior << ": it contains the form with one parameter less";
        last = fit.rms_error;
      }
    }
  }
}

// References: another program's Newton in 34 digits.
TEST(LeastSquares, CubicsAndQuarticsHaveTheirDigits) {
  const auto expect = [](const char* id, Measure measure, const std::vector<const char*>& expected) {
    const Fit fit = find_family(id)->fit({0, exact_surface(1.05)}, {.measure = measure});
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_TRUE(is_close(id, Decimal50(expected[i]), fit.parameters[i], 1e-13)) << i;
  };
  expect("fresnel-cubic", Measure::cosine,
         {"3.03034076152634194132011", "4.62868821591827595278074", "-19.1644332114280338745122"});
  expect("fresnel-cubic", Measure::cosine_weighted,
         {"0.173492797780757838678466", "6.17978342658093414606148", "-19.3188062119286487460192"});
  expect("fresnel-quartic", Measure::cosine,
         {"-25.2240965259111033278633", "22.7957661451595222628187", "0.741555585148798546441626",
          "-18.982857414274531610947"});
}

// References: another program's Newton on integrals in log(c), with 25 digits. The relative error is singular
// at c = 0, next to the end of the domain.
TEST(LeastSquares, RelativeErrorsOfBluntLobes) {
  struct Reference {
    const char* family;
    double exponent;
    Measure measure;
    const char* x;
  };
  for (const auto& [family, exponent, measure, x] :
       {Reference{"sg-offset", 1, Measure::cosine, "2.666359008753109603455005"},
        Reference{"sg-offset", 0.5, Measure::cosine, "1.433490380759289542864812"},
        Reference{"sg-offset", 0.1, Measure::angle, "0.1331749748797174365296766"},
        Reference{"sg-offset", 0.02, Measure::cosine, "0.02549207413272446097068649"},
        Reference{"phong-blinn", 0.75, Measure::cosine, "11.93450551163655834585718"},
        Reference{"phong-blinn", 0.75, Measure::cosine_weighted, "6.5540868171838501656905"}}) {
    const Fit fit = find_family(family)->fit(exponent, {.measure = measure, .error = Error::relative});
    ASSERT_EQ(fit.status, Status::converged) << family << " " << exponent << " " << fit.why;
    EXPECT_TRUE(is_close(family, Decimal50(x), fit.parameters[0], promised));
  }
  for (const Measure measure : measures) {
    for (const double k : {0.008, 0.02, 0.1, 0.4, 0.5, 0.75, 1.0, 1.3, 2.0, 20.0, 1e6}) {
      for (const char* id : {"sg-offset", "phong-blinn", "sg-scaled"}) {
        const Fit fit = find_family(id)->fit(k, {.measure = measure, .error = Error::relative});
        EXPECT_EQ(fit.status, Status::converged) << id << " " << k << " " << name(measure) << " " << fit.why;
        EXPECT_EQ(fit.digits, 14) << id << " " << k << " " << name(measure);
      }
    }
  }
}

/// A family's scale times its error against its own formula of the relative error.
template <class F>
void expect_relative_scale(const F& family, const std::array<double, F::parameters.size()>& p) {
  for (const double c : {0.75, 0.9, 1.0}) {
    const auto sample = family.sample(Cosine<double>{c, 1 - c});
    const double scaled = family.relative_scale(sample) * family.error(sample, p);
    const double expected = family.relative_error(sample, p);
    // A few roundings of form and target, of which the error is the difference.
    EXPECT_NEAR(scaled, expected, 1e-14 * (1 + std::abs(expected))) << F::info.id << " c = " << c;
  }
}

TEST(LeastSquares, TheScaleOfARelativeErrorIsItsRatioToTheError) {
  expect_relative_scale(SgOffset{{12}}, {0.5});
  expect_relative_scale(SgScaled{{12}}, {1.1, 0.5});
  expect_relative_scale(PhongBlinn{{12}}, {4.5});
  for (const Surface& surface : {Surface{}, exact_surface(1.5), exact_surface(0.2, 3)}) {
    expect_relative_scale(FresnelOneTerm{{surface}}, {9});
    expect_relative_scale(FresnelQuadratic{{surface}}, {-5, -7});
    expect_relative_scale(FresnelCubic{{surface}}, {-1, -5, -7});
    expect_relative_scale(FresnelQuartic{{surface}}, {-1, -1, -5, -7});
    expect_relative_scale(FresnelFourth{{surface}}, {0.9});
    expect_relative_scale(FresnelSquare{{surface}}, {2, -2});
    expect_relative_scale(FresnelRational{{surface}}, {0.5});
  }
}

// Five and more parameters, which no family has: the inverse is not a closed form, and the step is that of a
// known answer.
TEST(NewtonStep, SolvesForAnyNumberOfParameters) {
  for (const int n : {1, 2, 3, 4, 5, 9, most_fitted}) {
    ParameterMatrix<double> hessian(n, n);
    ParameterVector<double> expected(n);
    for (int i = 0; i < n; ++i) {
      expected[i] = 1 + i;
      for (int j = 0; j < n; ++j) hessian(i, j) = 1.0 / (1 + std::abs(i - j)) + (i == j ? n : 0);
    }
    const ParameterVector<double> gradient = -hessian * expected;
    const ParameterVector<double> step = newton_step(gradient, hessian);
    EXPECT_LT((step - expected).norm(), 1e-13 * expected.norm()) << n;
    EXPECT_TRUE(is_minimum(hessian)) << n;
    hessian(n - 1, n - 1) = -1;
    EXPECT_FALSE(is_minimum(hessian)) << n;
  }
}

// Of three parameters, any are given: the others are those of the form with these constants.
TEST(SampledErrors, OfFreeOnesAreThoseOfTheWhole) {
  const FresnelCubic family;
  const SampledProblem<FresnelCubic, double> sampled(family, Substitution::panels({}, family.shape()), 12);
  const SampledErrors all = sampled_errors(sampled, family, {});
  const std::vector p{-1.0, -5.0, -7.0};
  for (int which = 0; which < 7; ++which) {
    GivenParameters given(3);
    std::vector<Eigen::Index> free;
    std::vector<double> values;
    for (std::size_t i = 0; i < 3; ++i) {
      if (which >> i & 1) {
        given[i] = p[i];
      } else {
        free.push_back(static_cast<Eigen::Index>(i));
        values.push_back(p[i]);
      }
    }
    const SampledErrors part = of_free(all, given);
    EXPECT_EQ(part.square(values), all.square(p));
    EXPECT_EQ(part.gradient(values).gradient, all.gradient(p).gradient(free).eval());
    EXPECT_EQ(part.derivatives(values).hessian, all.derivatives(p).hessian(free, free).eval());
    std::vector<double> r(12), slopes(12 * values.size()), all_r(12), all_slopes(36);
    part.errors(values, r, slopes);
    all.errors(p, all_r, all_slopes);
    EXPECT_EQ(r, all_r);
    for (std::size_t i = 0; i < free.size(); ++i) {
      for (std::size_t node = 0; node < 12; ++node)
        EXPECT_EQ(slopes[12 * i + node], all_slopes[12 * static_cast<std::size_t>(free[i]) + node]);
    }
  }
}

// Settings of every status: only a fit that did not converge says why.
TEST(LeastSquares, EveryFailureSaysWhy) {
  int failed = 0;
  for (const FittableFamily& family : fittable_families()) {
    for (const Error error : {Error::absolute, Error::relative}) {
      for (const Domain domain : {Domain{}, {0, 0.001}, {0, 1e-12}, {0.2, 1}, {0.5, 0.5000000000000001}}) {
        for (const Setting& setting : {Setting(1e-320), Setting(0.003), Setting(1e160), Setting(1e308),
                                       Setting(0, exact_surface(0.5, 5)), Setting(0, exact_surface(10))}) {
          const Fit fit = family.fit(setting, {.error = error, .domain = domain});
          const bool is_answer = fit.status == Status::converged;
          EXPECT_EQ(fit.why.empty(), is_answer) << family.info.id << " " << setting.exponent << " "
                                                << describe(fit.metric) << " " << name(fit.status);
          failed += !is_answer;
        }
      }
    }
  }
  EXPECT_GT(failed, 50);
}

/// A family whose error does not depend on its parameter: every start is stationary, none an answer.
struct Flat : SgOffset {
  template <class T, class P>
  P error(const Sample<T>& s, const std::array<P, 1>&) const {
    return lift<P>(s.variable);
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
  EXPECT_EQ(solve_least_squares(Flat{{{1}}}, Metric{}).status, Status::not_finite) << "0/0 is no Newton step";
  EXPECT_EQ(solve_least_squares(TwoMinima{{{1}}}, Metric{}).status, Status::ambiguous);
  EXPECT_EQ(solve_least_squares(NotFinite{{{1}}}, Metric{}).status, Status::not_finite);
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
  EXPECT_EQ(solve_least_squares(AtMaximum{{{1}}}, Metric{}).status, Status::not_converged);
}

TEST(CorrectDigits, AreWholeAndCapped) {
  EXPECT_EQ(correct_digits(1e-6L), 6);
  EXPECT_EQ(correct_digits(1.1e-6L), 5);
  EXPECT_EQ(correct_digits(0.9e-6L), 6);
  EXPECT_EQ(correct_digits(1e-14L), 14);
  EXPECT_EQ(correct_digits(1e-19L), 14);
  EXPECT_EQ(correct_digits(0), 14);
  EXPECT_EQ(correct_digits(2), 0);
  EXPECT_EQ(correct_digits(std::numeric_limits<long double>::infinity()), 0);
  EXPECT_EQ(correct_digits(std::numeric_limits<long double>::quiet_NaN()), 0);
}

// If the expected rule had not converged, a second rule would be used, and its step counted: the choice saves
// its time. Sums and steps are those of the fit itself, in long double at its answer.
TEST(RuleChoice, TheFirstRuleSettlesLobes) {
  const auto leaves = [](const auto& family, const Metric& metric) {
    const auto optimum = solve_least_squares(family, metric);
    const auto panels = Substitution::panels(metric, family.shape());
    const unsigned size = fit_rules[first_rule(metric, family.shape())];
    const SampledProblem<std::remove_cvref_t<decltype(family)>, long double> problem(family, panels, size);
    const auto d = problem.derivatives({static_cast<long double>(optimum.parameters[0])});
    return static_cast<double>(std::abs(d.gradient[0] / d.hessian(0, 0)) / optimum.parameters[0]);
  };
  for (const Measure measure : measures) {
    for (int k = 1; k <= 64; ++k) {
      EXPECT_LT(leaves(SgOffset{{static_cast<double>(k)}}, {.measure = measure}), settled)
          << k << " " << name(measure);
      EXPECT_LT(leaves(PhongBlinn{{static_cast<double>(k)}}, {.measure = measure}), settled) << k;
    }
    for (const double k : {100.0, 1e3, 1e4, 1e6}) {
      EXPECT_LT(leaves(SgOffset{{k}}, {.measure = measure}), settled) << k;
      EXPECT_LT(leaves(PhongBlinn{{k}}, {.measure = measure}), settled) << k;
    }
  }
}

TEST(RuleChoice, GrowsWithTheDeclineAndKnowsItsLimits) {
  const auto size = [](const Metric& metric, const Shape& shape) {
    return fit_rules[first_rule(metric, shape)];
  };
  const Metric angle{.measure = Measure::angle};
  EXPECT_EQ(size({}, {.concentration = 6, .end_power = 3}), 14U);
  EXPECT_EQ(size({}, {.concentration = 20, .end_power = 10}), 18U);
  EXPECT_EQ(size({}, {.concentration = 22, .end_power = 11}), 22U);
  EXPECT_EQ(size({}, {.concentration = 40, .end_power = 20}), 26U);
  EXPECT_EQ(size({}, {.concentration = 2e6, .end_power = 1e6}), 26U) << "cut";
  EXPECT_EQ(size(angle, {.concentration = 6, .end_power = 3}), 22U);
  EXPECT_EQ(size(angle, {.concentration = 2e6, .end_power = 1e6}), 30U);
  EXPECT_EQ(size({.domain = {0.5, 1}}, {.concentration = 20, .end_power = 10}), 14U) << "half the decline";
  EXPECT_EQ(size({}, {.concentration = 5, .end_power = 2.5}), 26U) << "singular at c = 0";
  EXPECT_EQ(size({}, {.concentration = 101, .end_power = 50.5}), 26U) << "which is cut off";
  EXPECT_EQ(size({}, {}), 26U) << "of unknown shape";
  EXPECT_EQ(size({}, {.concentration = 6, .end_power = 3, .joint = Shape::Joint{0.5}}), 26U);
}

// A wrong expectation only costs time: the exponential is steeper than the shape says, the first rule's step
// is too large, and a larger one settles the fit all the same.
struct Understated : SgOffset {
  Shape shape() const { return {.concentration = 1, .end_power = exponent}; }
};

TEST(RuleChoice, AWrongExpectationIsCaught) {
  const Understated family{{{12}}};
  ASSERT_EQ(fit_rules[first_rule({}, family.shape())], 14U);
  const auto optimum = solve_least_squares(family, Metric{});
  const auto expected = solve_least_squares(SgOffset{{12}}, Metric{});
  EXPECT_EQ(optimum.status, Status::converged);
  EXPECT_EQ(optimum.digits, 14);
  EXPECT_NEAR(optimum.parameters[0] / expected.parameters[0], 1, promised);
}

// The correction recovers a quadratic from steps: independent steps give all of it.
TEST(Correct, FindsAHessianFromItsSteps) {
  const Eigen::Matrix2d truth{{3, 1}, {1, 2}};
  ParameterMatrix<double> hessian = Eigen::Matrix2d{{5, 0}, {0, 1}};
  for (const Eigen::Vector2d& step : {Eigen::Vector2d(1, 0), Eigen::Vector2d(1, 1)})
    correct(hessian, step, truth * step);
  EXPECT_LT((hessian - truth).norm(), 1e-14);
  correct(hessian, Eigen::Vector2d(1, 2), truth * Eigen::Vector2d(1, 2));
  EXPECT_LT((hessian - truth).norm(), 1e-14) << "nothing is learnt from what was expected";
}

/// A family that none of our rules can integrate: |c - 1/3|^0.1 has its kink inside.
struct Kinked : SgOffset {
  static std::array<std::array<double, 1>, 3> starts() { return {{{0.1}, {0.5}, {1}}}; }
  template <class T, class P>
  P error(const Sample<T>& s, const std::array<P, 1>& p) const {
    const T from_kink = -s.variable - integer<T>(2) / integer<T>(3);
    return lift<P>(power(max(from_kink, -from_kink), constant<T>("0.1"))) - p[0];
  }
};

// The best constant is the mean, (1/3^1.1 + (2/3)^1.1) / 1.1. If the rules do not settle, `digits` is what
// they reached, and not more.
TEST(LeastSquares, DigitsDoNotOverstateWhereNoRuleSettles) {
  const auto optimum = solve_least_squares(Kinked{{{1}}}, Metric{});
  EXPECT_EQ(optimum.status, Status::not_converged);
  const Decimal50 p("1.1");
  const Decimal50 truth = (pow(Decimal50(1) / 3, p) + pow(Decimal50(2) / 3, p)) / p;
  const Decimal50 error = abs(Decimal50(optimum.parameters[0]) / truth - 1);
  EXPECT_LT(optimum.digits, 6);
  EXPECT_GT(optimum.digits, 0);
  // two wrong rules agree by chance to at most one more digit than each has
  EXPECT_LE(error, pow(Decimal50(10), 1 - optimum.digits));
}

// Gradient and Hessian by Jets of Jets against central differences of the summed square itself, in long
// double.
TEST(SampledProblem, DerivativesAreThoseOfTheSquare) {
  const FresnelQuadratic family;
  const SampledProblem<FresnelQuadratic, long double> problem(family,
                                                              Substitution::panels({}, family.shape()), 26);
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
  const auto first = problem.gradient(p);
  EXPECT_EQ(first.square, d.square);
  EXPECT_NEAR(static_cast<double>(first.gradient[0] / d.gradient[0]), 1, 1e-16);
  EXPECT_NEAR(static_cast<double>(first.gradient[1] / d.gradient[1]), 1, 1e-16);
  EXPECT_EQ(problem.square(p), d.square);
}

TEST(Status, HasNames) {
  EXPECT_EQ(name(Status::converged), "converged");
  EXPECT_EQ(name(Status::ambiguous), "ambiguous");
  EXPECT_EQ(name(Status::not_converged), "not-converged");
  EXPECT_EQ(name(Status::at_border), "at-border");
  EXPECT_EQ(name(Status::not_finite), "not-finite");
}

}  // namespace
}  // namespace shadefit
