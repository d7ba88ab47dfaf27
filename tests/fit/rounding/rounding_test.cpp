#include "fit/rounding/rounding.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "fit/proof/running_error.hpp"
#include "fit/rounding/rounding_problem.hpp"
#include "fit/scalars/multiprecision.hpp"
#include "fit/support/user_error.hpp"
#include "tests/refusal.hpp"

namespace shadefit {
namespace {

const NumberFormat half_format{NumberFormat::Kind::half};
const NumberFormat bfloat16{NumberFormat::Kind::bfloat16};
const NumberFormat single{NumberFormat::Kind::single};

Fit fit_of(std::string_view family, double exponent = 0, const Domain& domain = {}) {
  return find_family(family)->fit({exponent}, {.domain = domain});
}

/// The largest error in half over all inputs by a plain loop over Eigen::half; stops beyond `limit`.
template <class F>
double error_in_half(const F& family, const std::array<double, F::parameters.size()>& p, double limit) {
  using T = NarrowResult<HalfFormat>;
  std::array<T, F::parameters.size()> q;
  for (std::size_t i = 0; i < q.size(); ++i) q[i] = T(p[i]);
  const BinaryLattice<HalfFormat> lattice;
  const std::int64_t count = lattice.nearest(1) + 1;
  double worst = 0;
  constexpr std::int64_t stride = 3571;  // prime: far apart, so that a bad constant is soon seen
  for (std::int64_t i = 0; i < count && worst <= limit; ++i) {
    const double c = lattice.value(i * stride % count);
    const auto form = static_cast<double>(F::form_of(T(c), T(exponent_of(family)), q));
    const double target = F::target_of(c, exponent_of(family));
    worst = std::isnan(form) ? unbounded : std::max(worst, std::abs(form - target));
  }
  return worst;
}

// Constants in half that beat the rounded published ones.
TEST(Rounding, HalfConstantsBeatTheRoundedPublishedOnes) {
  struct Case {
    std::string_view family;
    double exponent;
    std::vector<double> published;
  };
  for (const Case& c :
       {Case{"fresnel-quadratic", 0, {-5.55473, -6.98316}}, Case{"fresnel-one-term", 0, {8.35}},
        Case{"sg-offset", 5, {0.788}}, Case{"sg-offset", 10, {0.775}}, Case{"phong-blinn", 64, {4.2}}}) {
    const Rounded rounded = round_fit(fit_of(c.family, c.exponent), half_format, c.published);
    EXPECT_TRUE(rounded.is_proven) << c.family;
    EXPECT_EQ(rounded.searched, "all finite numbers of the format");
    EXPECT_LT(rounded.best.max_error, 0.91 * rounded.published->max_error) << c.family;
    EXPECT_LE(rounded.best.max_error, rounded.naive.max_error) << c.family;
    EXPECT_GE(*rounded.best.gpu_bound, rounded.best.max_error) << c.family;
  }
}

// Each a landmark of the report, and of the halves -5.4921875 and -7.0078125.
TEST(Rounding, QuadraticInHalf) {
  const Rounded rounded = round_fit(fit_of("fresnel-quadratic"), half_format, {-5.55473, -6.98316});
  EXPECT_EQ(rounded.best.parameters, (std::vector{-0x1.5f8p+2, -0x1.c08p+2}));
  EXPECT_EQ(rounded.best.texts, (std::vector<std::string>{"-5.492", "-7.008"}));
  EXPECT_NEAR(rounded.best.max_error, 0.0035796, 5e-8);
  EXPECT_EQ(rounded.naive.texts, (std::vector<std::string>{"-5.555", "-6.984"}));
  EXPECT_NEAR(rounded.naive.max_error, 0.0040267, 5e-8);
  EXPECT_EQ(rounded.best.max_error, error_in_half(FresnelQuadratic{}, {-0x1.5f8p+2, -0x1.c08p+2}, 1));
  EXPECT_FALSE(rounded.best.real_error.has_value());
  EXPECT_NEAR(*rounded.best.srgb_codes, 8, 0.1);
}

// Every half A, without an interval.
TEST(Rounding, BestOfAllHalvesByBruteForce) {
  const Rounded rounded = round_fit(fit_of("fresnel-one-term"), half_format, {});
  const BinaryLattice<HalfFormat> lattice;
  double best = error_in_half(FresnelOneTerm{}, {8.35}, 1);  // a start that most fail against early
  for (std::int64_t i = -lattice.last(); i <= lattice.last(); ++i)
    best = std::min(best, error_in_half(FresnelOneTerm{}, {lattice.value(i)}, best));
  EXPECT_EQ(rounded.best.max_error, best);
}

TEST(Rounding, SearchOfABoxIsBruteForce) {
  const FresnelQuadratic family;
  NarrowProblem<FresnelQuadratic, HalfFormat> problem(family, Error::absolute, {});
  const auto& lattice = problem.lattice();
  for (const auto& [a, b] : {std::pair{-5.55473, -6.98316}, {-5.49, -7.01}, {-4.0, -7.5}}) {
    const LatticePoint<2> centre{lattice.nearest(a), lattice.nearest(b)};
    const LatticeBox<2> box{{centre[0] - 9, centre[1] - 9}, {centre[0] + 9, centre[1] + 9}};
    const auto found = search_lattice<2>(lattice_problem<2>(problem), box, {centre}, 100000, keep_going);
    double best = 1;
    for (std::int64_t i = box.lower[0]; i <= box.upper[0]; ++i) {
      for (std::int64_t j = box.lower[1]; j <= box.upper[1]; ++j)
        best = std::min(best, error_in_half(family, {lattice.value(i), lattice.value(j)}, best));
    }
    EXPECT_TRUE(found.is_proven);
    EXPECT_EQ(found.error, best);
    EXPECT_EQ(problem.worst_of({lattice.value(found.point[0]), lattice.value(found.point[1])}).error, best);
    EXPECT_LT(found.evaluated, 100) << "of 361";
  }
}

// The bound of a box is at most the error of every point in it, for every set of trials.
TEST(Rounding, BoundsOfBoxesHold) {
  const SgOffset family{{10}};
  NarrowProblem<SgOffset, Bfloat16Format> problem(family, Error::absolute, {});
  const std::int64_t centre = problem.lattice().nearest(0.7);
  for (const std::int64_t width : {0, 1, 5, 40}) {
    for (std::int64_t i = centre - 60; i <= centre + 60; ++i) {
      const double error = problem.worst_of({problem.lattice().value(i)}).error;
      EXPECT_LE(problem.bound({{i - width}, {i}}, unbounded), error);
      EXPECT_LE(problem.bound({{i}, {i + width}}, unbounded), error);
      if (i % 7 == 0) problem.error({i}, unbounded);
    }
  }
}

// Each parameter one step up or down is no better, and the ruler sees the step.
TEST(Rounding, MutationsAreNoBetter) {
  for (const NumberFormat& format : {half_format, bfloat16}) {
    const Rounded rounded = round_fit(fit_of("fresnel-quadratic"), format, {});
    const auto expect_worse = [&](const auto& problem) {
      const auto& lattice = problem.lattice();
      int changed = 0;
      for (const std::size_t i : {0u, 1u}) {
        for (const int step : {-1, 1}) {
          auto p = parameter_array<FresnelQuadratic>(rounded.best.parameters);
          p[i] = lattice.value(lattice.nearest(p[i]) + step);
          const double error = problem.worst_of(p).error;
          EXPECT_GE(error, rounded.best.max_error);
          changed += error > rounded.best.max_error ? 1 : 0;
        }
      }
      EXPECT_GE(changed, 2);
    };
    if (format == half_format) {
      expect_worse(NarrowProblem<FresnelQuadratic, HalfFormat>({}, Error::absolute, {}));
    } else {
      expect_worse(NarrowProblem<FresnelQuadratic, Bfloat16Format>({}, Error::absolute, {}));
    }
  }
}

TEST(Rounding, GivesUpHonestly) {
  const Fit fit = fit_of("fresnel-quadratic");
  const Rounded few = round_fit(fit, half_format, {}, keep_going, 40);
  EXPECT_FALSE(few.is_proven);
  EXPECT_EQ(few.searched, "the constants within 16 steps of the format");
  const Rounded all = round_fit(fit, half_format, {});
  EXPECT_GE(few.best.max_error, all.best.max_error);
  EXPECT_LE(few.best.max_error, few.naive.max_error);
  int called = 0;
  round_fit(fit, bfloat16, {}, [&] { ++called; });
  EXPECT_GT(called, 0);
  EXPECT_THROW(round_fit(fit, bfloat16, {}, [] { throw std::runtime_error("stop"); }), std::runtime_error);
}

/// scale (form - target) is what the family calls its error.
template <class F>
void expect_measured(const F& family, const std::array<double, F::parameters.size()>& p) {
  for (const double c : {0.2, 0.5, 0.93}) {
    const Cosine<double> at{c, 1 - c};
    const double form = F::form_of(c, exponent_of(family), p);
    const auto absolute = measured_at(family, Error::absolute, at);
    const auto relative = measured_at(family, Error::relative, at);
    EXPECT_NEAR(absolute.scale * (form - absolute.target), family.error(family.sample(at), p), 1e-13);
    EXPECT_NEAR(relative.scale * (form - relative.target), family.relative_error(family.sample(at), p), 1e-9);
  }
}

TEST(Rounding, MeasuresTheErrorsOfTheFamilies) {
  expect_measured(SgOffset{{3.5}}, {0.8});
  expect_measured(PhongBlinn{{3.5}}, {4.2});
  expect_measured(FresnelOneTerm{}, {8.35});
  expect_measured(FresnelQuadratic{{exact_surface(1.5)}}, {-5.5, -7.0});
  expect_measured(FresnelQuadratic{{schlick_surface(1.5)}}, {-5.5, -7.0});
  expect_measured(FresnelOneTerm{{exact_surface(0.43, 2.455)}}, {8.35});
}

TEST(Rounding, RelativeErrorsAndDomains) {
  Fit fit = fit_of("fresnel-quadratic");
  fit.metric.error = Error::relative;
  const Rounded relative = round_fit(fit, half_format, {});
  EXPECT_TRUE(relative.is_proven);
  EXPECT_LT(relative.best.max_error, relative.naive.max_error);
  const NarrowProblem<FresnelQuadratic, HalfFormat> problem({}, Error::relative, {});
  EXPECT_EQ(problem.worst_of(parameter_array<FresnelQuadratic>(relative.naive.parameters)).error,
            relative.naive.max_error);

  // the inputs are those of the domain, its ends too
  const NarrowProblem<SgOffset, HalfFormat> part(SgOffset{{8}}, Error::absolute, {0.25, 0.75});
  EXPECT_EQ(part.inputs().front().cos_theta, 0.25);
  EXPECT_EQ(part.inputs().back().cos_theta, 0.75);
  EXPECT_EQ(part.inputs().size(), 1024 + 512 + 1u);
  const NarrowProblem<SgOffset, HalfFormat> whole(SgOffset{{8}}, Error::absolute, {});
  EXPECT_EQ(whole.inputs().size(), 15361u);
  const NarrowProblem<SgOffset, HalfFormat> odd(SgOffset{{8}}, Error::absolute, {0.3, 0.7});
  EXPECT_GE(odd.inputs().front().cos_theta, 0.3);
  EXPECT_LE(odd.inputs().back().cos_theta, 0.7);
}

/// |float evaluation - 50 digits| at floats all over [0, 1], against the bound.
template <class F>
void expect_bound_of_float(const F& family, const std::array<float, F::parameters.size()>& p,
                           double at_most_times) {
  std::array<double, F::parameters.size()> wide;
  std::array<Decimal50, F::parameters.size()> truth;
  for (std::size_t i = 0; i < p.size(); ++i) {
    wide[i] = static_cast<double>(p[i]);
    truth[i] = Decimal50(wide[i]);
  }
  const auto error_on = [&](const Rounding& rounding) {
    return bound_of_rounding(
        [&](const Cosine<Interval>& c) {
          std::array<RunningError, F::parameters.size()> q;
          for (std::size_t i = 0; i < q.size(); ++i) q[i] = RunningError{Interval(wide[i]), 0, &rounding};
          const RunningError k{Interval(exponent_of(family)), 0, &rounding};
          return F::form_of(RunningError::operand(c.cos_theta, rounding), k, q).error;
        },
        {});
  };
  const double bound = error_on(float_rounding);
  double seen = 0;
  const auto try_at = [&](double cosine) {
    const auto c = static_cast<float>(cosine);
    using T = NarrowResult<FloatFormat>;
    std::array<T, F::parameters.size()> q;
    for (std::size_t i = 0; i < q.size(); ++i) q[i] = T(wide[i]);
    const auto computed =
        static_cast<double>(F::form_of(T(static_cast<double>(c)), T(exponent_of(family)), q));
    const Decimal50 exact = F::form_of(Decimal50(c), Decimal50(exponent_of(family)), truth);
    seen = std::max(seen, abs(Decimal50(computed) - exact).template convert_to<double>());
  };
  for (int i = 0; i <= 2000; ++i) {
    try_at(i / 2000.0);
    try_at(1 - i / 2000.0 / (1 + exponent_of(family)));
  }
  EXPECT_LE(seen, bound) << F::info.id;
  EXPECT_GE(at_most_times * seen, bound) << F::info.id << ": the bound is far off";
  EXPECT_GT(error_on(gpu_float_rounding), bound);
  EXPECT_LT(error_on(gpu_float_rounding), 12 * bound);
}

// A bound assumes the worst of every rounding, also of the subtraction c - 1, which is mostly exact.
TEST(RunningError, BoundsWhatFloatsShow) {
  expect_bound_of_float(FresnelQuadratic{}, {-5.55473F, -6.98316F}, 4);
  expect_bound_of_float(FresnelOneTerm{}, {8.35F}, 3);
  expect_bound_of_float(SgOffset{{10}}, {0.775F}, 4);
  expect_bound_of_float(SgOffset{{1e6}}, {0.775F}, 4);
  expect_bound_of_float(PhongBlinn{{64}}, {4.2F}, 12);
}

TEST(RunningError, OfAQuotientAndARoot) {
  const RunningError x{Interval(3), 0, &float_rounding}, y{Interval(7), 0, &float_rounding};
  const RunningError q = x / y, r = sqrt(q), l = log2(q);
  const float computed = 3.0F / 7.0F;
  EXPECT_LE(std::abs(static_cast<double>(computed) - 3.0 / 7), q.error);
  EXPECT_LE(q.error, 0x1p-24);
  EXPECT_LE(std::abs(static_cast<double>(std::sqrt(computed)) - std::sqrt(3.0 / 7)), r.error);
  EXPECT_LE(r.error, 3 * 0x1p-24);
  EXPECT_LE(std::abs(static_cast<double>(std::log2(computed)) - std::log2(3.0 / 7)), l.error);
  EXPECT_LE(l.error, 8 * 0x1p-24);
  const RunningError none = x / (y - y);
  EXPECT_EQ(none.error, std::numeric_limits<double>::infinity());
}

TEST(Rounding, FloatConstantsBeatThePublishedOnes) {
  const Rounded rounded = round_fit(fit_of("fresnel-quadratic"), single, {-5.55473, -6.98316});
  EXPECT_TRUE(rounded.is_proven);
  // the minimax pair of real numbers has 0.00340241163..: no float is better, and the best nearly as good
  EXPECT_NEAR(*rounded.best.real_error, 0.0034024116, 1e-9);
  EXPECT_LT(rounded.best.max_error, 0.91 * rounded.published->max_error);
  for (const RoundedConstants& c : {rounded.best, rounded.naive, *rounded.published}) {
    EXPECT_GE(c.max_error, *c.real_error + *c.rounding_error);
    EXPECT_LT(*c.rounding_error, 1e-7);
    EXPECT_GT(*c.gpu_bound, c.max_error);
    // no sample exceeds the bound, and the bound is near
    double seen = 0;
    for (int i = 0; i <= 100000; ++i) {
      const auto x = static_cast<float>(i) / 100000.0F;
      const float form =
          fresnel_quadratic(x, static_cast<float>(c.parameters[0]), static_cast<float>(c.parameters[1]));
      seen = std::max(seen, std::abs(static_cast<double>(form) - schlick_weight(static_cast<double>(x))));
    }
    EXPECT_LE(seen, c.max_error);
    EXPECT_GE(seen, c.max_error - 2e-7);
  }
}

// In one dimension the neighbours decide: the errors of all three by their own extrema.
TEST(Rounding, DecimalsAreTheBestOfTheirNeighbours) {
  for (const int digits : {1, 2, 3, 6}) {
    const Rounded rounded =
        round_fit(fit_of("sg-offset", 10), {NumberFormat::Kind::decimal, digits}, {0.775});
    EXPECT_TRUE(rounded.is_proven);
    const DecimalLattice lattice{digits};
    const std::int64_t best = lattice.nearest(rounded.best.parameters[0]);
    for (std::int64_t i = best - 3; i <= best + 3; ++i) {
      const double error =
          find_family("sg-offset")->max_abs_error({10}, {}, std::array{lattice.value(i)}).magnitude;
      EXPECT_LE(*rounded.best.real_error, error * (1 + 1e-8)) << digits << " " << lattice.text(i);
    }
    EXPECT_EQ(lattice.text(best), rounded.best.texts[0]);
    EXPECT_FALSE(rounded.best.gpu_bound.has_value());
  }
}

TEST(Rounding, GivenParametersStay) {
  Metric metric;
  metric.constraints.held = {{"b", -7}};
  const Rounded rounded = round_fit(find_family("fresnel-quadratic")->fit({0}, metric), half_format, {});
  EXPECT_EQ(rounded.best.parameters[1], -7);
  EXPECT_TRUE(rounded.is_proven);
  EXPECT_EQ(rounded.searched, "all finite numbers of the format, for the parameters that are not given");
  const BinaryLattice<HalfFormat> lattice;
  double best = rounded.naive.max_error;
  for (std::int64_t i = lattice.nearest(-8); i <= lattice.nearest(-3); ++i)
    best = std::min(best, error_in_half(FresnelQuadratic{}, {lattice.value(i), -7}, best));
  EXPECT_EQ(rounded.best.max_error, best);
}

// Three parameters: only the neighbourhood is searched.
TEST(Rounding, OfManyParametersTheNeighbourhood) {
  const Rounded rounded = round_fit(fit_of("fresnel-cubic"), half_format, {});
  EXPECT_EQ(rounded.searched, "the constants within 16 steps of the format");
  EXPECT_LT(rounded.best.max_error, rounded.naive.max_error);
  EXPECT_LT(rounded.best.max_error, round_fit(fit_of("fresnel-quadratic"), half_format, {}).best.max_error);
}

TEST(Rounding, RefusesWhatAFormatCannotHold) {
  using testing::refusal;
  EXPECT_EQ(refusal([] { round_fit(fit_of("sg-offset", 0.1), half_format, {}); }),
            "exponent 0.1 is not a number of half: the nearest is 0.0999755859375");
  EXPECT_EQ(refusal([] { round_fit(fit_of("sg-offset", 1e6), half_format, {}); }),
            "exponent 1e+06 is not a number of half: the largest is 65504");
  EXPECT_EQ(refusal([] { round_fit(fit_of("sg-offset", 1000), bfloat16, {}); }), "");
  EXPECT_EQ(refusal([] { round_fit(fit_of("fresnel-one-term"), half_format, {70000}); }),
            "fresnel-one-term: A = 70000 overflows half: the largest is 65504");
  EXPECT_EQ(refusal([] {
              round_fit(fit_of("fresnel-one-term"), {NumberFormat::Kind::decimal, 3}, {1e30});
            }),
            "fresnel-one-term: A = 1e+30 overflows decimal:3: the largest is 1e21");
  EXPECT_EQ(refusal([] {
              round_fit(fit_of("sg-offset", 8, {0.50001, 0.50002}), half_format, {});
            }),
            "--domain '0.50001:0.50002' holds no number of half");
  const auto with = [&](const auto& change) {
    Fit fit = fit_of("fresnel-one-term");
    change(fit.metric);
    return refusal([&] { round_fit(fit, half_format, {}); });
  };
  EXPECT_EQ(with([](Metric& m) { m.weight = "1 + c"; }),
            "--round 'half' does not apply with --weight: the largest error is searched without one");
  const std::string broken = ": rounding would break it";
  EXPECT_EQ(with([](Metric& m) { m.constraints.exact_at = {1}; }),
            "--round 'half' does not apply with --exact-at" + broken);
  EXPECT_EQ(with([](Metric& m) { m.constraints.one_sided = Side::above; }),
            "--round 'half' does not apply with --one-sided" + broken);
  EXPECT_EQ(with([](Metric& m) { m.constraints.at_most = 1; }),
            "--round 'half' does not apply with --at-most" + broken);
  EXPECT_EQ(with([](Metric& m) { m.constraints.at_least = 0; }),
            "--round 'half' does not apply with --at-least" + broken);
}

TEST(Rounding, FormatsByName) {
  for (const char* text : {"half", "bfloat16", "float", "decimal:1", "decimal:17"})
    EXPECT_EQ(to_text(parse_number_format(text)), text);
  for (const char* text : {"", "Half", "double", "decimal", "decimal:", "decimal:0", "decimal:18",
                           "decimal:x", "decimal:5x", "decimal:-1", "decimal: 5", "decimal:99999999999"})
    EXPECT_THROW(parse_number_format(text), UserError) << text;
}

}  // namespace
}  // namespace shadefit
