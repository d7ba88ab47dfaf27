#include "fit/rounding/round_family.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "approx/fresnel.hpp"
#include "fit/rounding/lattice.hpp"
#include "fit/scalars/end_arithmetics.hpp"
#include "fit/scalars/narrow_result.hpp"
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

constexpr auto quadratic = [](const auto& c, const auto& p) { return fresnel_quadratic(c, p[0], p[1]); };
constexpr auto one_term = [](const auto& c, const auto& p) { return fresnel_one_term(c, p[0]); };

/// The largest error of a Fresnel form in a narrow format over all inputs by a plain loop; stops beyond
/// `limit`.
template <class Format, class Form, std::size_t N>
double error_in(const Form& form_of, const std::array<double, N>& p, double limit) {
  using T = NarrowResult<Format>;
  std::array<T, N> q;
  for (std::size_t i = 0; i < N; ++i) q[i] = T(p[i]);
  const BinaryLattice<Format> lattice;
  const std::int64_t count = lattice.nearest(1) + 1;
  double worst = 0;
  constexpr std::int64_t stride = 3571;  // prime: far apart, so that a bad constant is soon seen
  for (std::int64_t i = 0; i < count && worst <= limit; ++i) {
    const double c = lattice.value(i * stride % count);
    const auto form = static_cast<double>(form_of(T(c), q));
    worst = std::isnan(form) ? unbounded : std::max(worst, std::abs(form - schlick_weight(c)));
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
    const RoundedStudy rounded = round_fit(fit_of(c.family, c.exponent), half_format, c.published);
    EXPECT_TRUE(rounded.is_proven) << c.family;
    EXPECT_EQ(rounded.searched, "all finite numbers of the format");
    EXPECT_LT(rounded.best.max_error, 0.91 * rounded.published->max_error) << c.family;
    EXPECT_LE(rounded.best.max_error, rounded.naive.max_error) << c.family;
    EXPECT_GE(*rounded.best.gpu_bound, rounded.best.max_error) << c.family;
  }
}

// Each a landmark of the report, and of the halves -5.4921875 and -7.0078125.
TEST(Rounding, QuadraticInHalf) {
  const RoundedStudy rounded = round_fit(fit_of("fresnel-quadratic"), half_format, {-5.55473, -6.98316});
  EXPECT_EQ(rounded.best.values, (std::vector{-0x1.5f8p+2, -0x1.c08p+2}));
  EXPECT_EQ(rounded.best.texts, (std::vector<std::string>{"-5.492", "-7.008"}));
  EXPECT_NEAR(rounded.best.max_error, 0.0035796, 5e-8);
  EXPECT_EQ(rounded.naive.texts, (std::vector<std::string>{"-5.555", "-6.984"}));
  EXPECT_NEAR(rounded.naive.max_error, 0.0040267, 5e-8);
  EXPECT_EQ(rounded.best.max_error, error_in<HalfFormat>(quadratic, std::array{-0x1.5f8p+2, -0x1.c08p+2}, 1));
  EXPECT_FALSE(rounded.best.real_error.has_value());
  EXPECT_NEAR(*rounded.best.srgb_codes, 8, 0.1);
}

// Every half A, without an interval.
TEST(Rounding, BestOfAllHalvesByBruteForce) {
  const RoundedStudy rounded = round_fit(fit_of("fresnel-one-term"), half_format, {});
  const BinaryLattice<HalfFormat> lattice;
  double best = error_in<HalfFormat>(one_term, std::array{8.35}, 1);  // a start that most fail against early
  for (std::int64_t i = -lattice.last(); i <= lattice.last(); ++i)
    best = std::min(best, error_in<HalfFormat>(one_term, std::array{lattice.value(i)}, best));
  EXPECT_EQ(rounded.best.max_error, best);
}

// A parameter that is one step off gives no smaller error. At least two of the four steps give a larger one.
TEST(Rounding, MutationsAreNoBetter) {
  for (const NumberFormat& format : {half_format, bfloat16}) {
    const RoundedStudy rounded = round_fit(fit_of("fresnel-quadratic"), format, {});
    int changed = 0;
    for (const std::size_t i : {0u, 1u}) {
      for (const int step : {-1, 1}) {
        const auto moved = [&](const auto& lattice) {
          std::array p{rounded.best.values[0], rounded.best.values[1]};
          p[i] = lattice.value(lattice.nearest(p[i]) + step);
          return p;
        };
        const double error =
            format == half_format
                ? error_in<HalfFormat>(quadratic, moved(BinaryLattice<HalfFormat>{}), 1)
                : error_in<Bfloat16Format>(quadratic, moved(BinaryLattice<Bfloat16Format>{}), 1);
        EXPECT_GE(error, rounded.best.max_error);
        changed += error > rounded.best.max_error ? 1 : 0;
      }
    }
    EXPECT_GE(changed, 2);
  }
}

TEST(Rounding, RelativeErrors) {
  Fit fit = fit_of("fresnel-quadratic");
  fit.metric.error = Error::relative;
  const RoundedStudy relative = round_fit(fit, half_format, {});
  EXPECT_TRUE(relative.is_proven);
  EXPECT_LT(relative.best.max_error, relative.naive.max_error);
}

TEST(Rounding, FloatConstantsBeatThePublishedOnes) {
  const RoundedStudy rounded = round_fit(fit_of("fresnel-quadratic"), single, {-5.55473, -6.98316});
  EXPECT_TRUE(rounded.is_proven);
  // the minimax pair of real numbers has 0.00340241163..: no float is better, and the best nearly as good
  EXPECT_NEAR(*rounded.best.real_error, 0.0034024116, 1e-9);
  EXPECT_LT(rounded.best.max_error, 0.91 * rounded.published->max_error);
  for (const RoundedStudySet& c : {rounded.best, rounded.naive, *rounded.published}) {
    EXPECT_GE(c.max_error, *c.real_error + *c.rounding_error);
    EXPECT_LT(*c.rounding_error, 1e-7);
    EXPECT_GT(*c.gpu_bound, c.max_error);
    // no sample exceeds the bound, and the bound is near
    double seen = 0;
    for (int i = 0; i <= 100000; ++i) {
      const auto x = static_cast<float>(i) / 100000.0F;
      const float form =
          fresnel_quadratic(x, static_cast<float>(c.values[0]), static_cast<float>(c.values[1]));
      seen = std::max(seen, std::abs(static_cast<double>(form) - schlick_weight(static_cast<double>(x))));
    }
    EXPECT_LE(seen, c.max_error);
    EXPECT_GE(seen, c.max_error - 2e-7);
  }
}

// In one dimension the neighbours decide: the errors of all three by their own extrema.
TEST(Rounding, DecimalsAreTheBestOfTheirNeighbours) {
  for (const int digits : {1, 2, 3, 6}) {
    const RoundedStudy rounded =
        round_fit(fit_of("sg-offset", 10), {NumberFormat::Kind::decimal, digits}, {0.775});
    EXPECT_TRUE(rounded.is_proven);
    const DecimalLattice lattice{digits};
    const std::int64_t best = lattice.nearest(rounded.best.values[0]);
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
  const RoundedStudy rounded = round_fit(find_family("fresnel-quadratic")->fit({0}, metric), half_format, {});
  EXPECT_EQ(rounded.best.values[1], -7);
  EXPECT_TRUE(rounded.is_proven);
  EXPECT_EQ(rounded.searched, "all finite numbers of the format");
  const BinaryLattice<HalfFormat> lattice;
  double best = rounded.naive.max_error;
  for (std::int64_t i = lattice.nearest(-8); i <= lattice.nearest(-3); ++i)
    best = std::min(best, error_in<HalfFormat>(quadratic, std::array{lattice.value(i), -7.0}, best));
  EXPECT_EQ(rounded.best.max_error, best);
}

// Three parameters: only the neighbourhood is searched.
TEST(Rounding, OfManyParametersTheNeighbourhood) {
  const RoundedStudy rounded = round_fit(fit_of("fresnel-cubic"), half_format, {});
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
            "--round 'half': A = 70000 overflows: the largest is 65504");
  EXPECT_EQ(refusal([] {
              round_fit(fit_of("fresnel-one-term"), {NumberFormat::Kind::decimal, 3}, {1e30});
            }),
            "--round 'decimal:3': A = 1e+30 overflows: the largest is 1e21");
  EXPECT_EQ(refusal([] {
              round_fit(fit_of("sg-offset", 8, {0.50001, 0.50002}), half_format, {});
            }),
            "--round 'half': the range of c holds no number of half");
  const auto with = [&](const auto& change) {
    Fit fit = fit_of("fresnel-one-term");
    change(fit.metric);
    return refusal([&] { round_fit(fit, half_format, {}); });
  };
  EXPECT_EQ(with([](Metric& m) { m.weight = "1 + c"; }),
            "--round 'half' does not apply with --weight: the largest error is searched without one");
  EXPECT_EQ(with([](Metric& m) { m.constraints.at_most = 1; }),
            "--round 'half' does not go with a constraint: rounding would break it");
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
