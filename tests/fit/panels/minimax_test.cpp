#include "fit/panels/minimax.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "fit/catalogue/family.hpp"
#include "fit/scalars/multiprecision.hpp"
#include "fit/support/decimal.hpp"
#include "reports/io/csv.hpp"
#include "reports/io/files.hpp"
#include "tests/accuracy.hpp"

namespace shadefit {
namespace {

using testing::is_close;

// The promised digits.
constexpr double minimax_promise = 1e-13;

Metric minimax(Error error = Error::absolute) {
  return {.norm = Norm::minimax, .error = error};
}

/// The metric of a row of minimax.csv: `extra` as `describe` says it.
Metric metric_of(const std::string& error, const std::string& extra) {
  Metric metric = minimax(error == "relative" ? Error::relative : Error::absolute);
  if (extra.starts_with("weight ")) metric.weight = extra.substr(7);
  if (extra == "b = -7") metric.constraints.held = {{"b", -7}};
  if (extra == "form >= target") metric.constraints.one_sided = Side::above;
  if (extra == "form >= 0.001") metric.constraints.at_least = 0.001;
  if (extra == "form <= 1") metric.constraints.at_most = 1;
  return metric;
}

// Newton on the whole stationary system in 60 digits: tests/references/make_minimax_references.py.
TEST(Minimax, HasThirteenDigitsOfEveryReference) {
  const std::string file = SHADEFIT_SOURCE_DIR "/tests/references/minimax.csv";
  const auto rows = parse_csv(read_file(file), "minimax.csv").rows;
  EXPECT_EQ(rows.size(), 109U);
  for (const auto& row : rows) {
    const Family& family = *find_family(row[0]);
    const Fit fit = family.fit(parse_number(row[2]).value_or(0), metric_of(row[3], row[4]));
    const std::string what = row[0] + " " + row[1] + " " + row[2] + " " + row[3] + " " + row[4];
    ASSERT_EQ(fit.status, Status::converged) << what << ": " << fit.why;
    EXPECT_EQ(fit.digits, 14) << what;
    const double value =
        row[1] == "level" ? fit.level.value() : fit.parameters[parameter_index(family, row[1])];
    EXPECT_TRUE(is_close(what, Decimal50(row[5]), value, minimax_promise));
  }
}

// n + 1 places with equal magnitude and alternating signs, and no larger error.
TEST(Minimax, TheErrorAlternates) {
  for (const Family& family : families()) {
    for (const Error error : {Error::absolute, Error::relative}) {
      for (const double exponent : {0.5, 5.0, 37.5, 1e4}) {
        if (!family.has_exponent() && exponent != 5) continue;
        const Fit fit = family.fit(exponent, minimax(error));
        const std::string what = std::string(family.id) + " " + std::string(name(error)) + " " +
                                 std::to_string(exponent) + " " + fit.why;
        ASSERT_EQ(fit.status, Status::converged) << what;
        EXPECT_EQ(fit.alternation.size(), family.parameters.size() + 1) << what;
        // A parameter rounded to a double moves the error by as much as that, and the level may be small.
        const double tolerance = 1e-12 + 2e-15 / *fit.level;
        double weights = 0;
        for (std::size_t i = 0; i < fit.alternation.size(); ++i) {
          const AlternationPoint& point = fit.alternation[i];
          const int sign = point.touch == Touch::highest ? 1 : -1;
          EXPECT_NEAR(point.error * sign / *fit.level, 1, tolerance) << what;
          EXPECT_GT(point.multiplier, 0) << what;
          weights += point.multiplier;
          if (i == 0) continue;
          EXPECT_NE(point.touch, fit.alternation[i - 1].touch) << what;
          EXPECT_LT(point.at.one_minus_cos, fit.alternation[i - 1].at.one_minus_cos) << what;
        }
        EXPECT_NEAR(weights, 1, 1e-12) << what << ": Kolmogorov's weights";
        const double largest = family.largest_error(exponent, fit.metric, fit.parameters).magnitude;
        EXPECT_NEAR(largest / *fit.level, 1, 10 * tolerance) << what << ": by the search of another file";
      }
    }
  }
}

TEST(Minimax, BeatsLeastSquaresInItsOwnNormAlone) {
  for (const Family& family : families()) {
    const Fit least_squares = family.fit(5, {}), least_level = family.fit(5, minimax());
    EXPECT_LT(*least_level.level, least_squares.max_abs_error.magnitude) << family.id;
    EXPECT_GT(least_level.rms_error, least_squares.rms_error) << family.id;
    EXPECT_LT(least_level.rms_error, *least_level.level) << family.id;
  }
}

TEST(Minimax, TheMeasureHasNoInfluence) {
  Metric angle = minimax();
  angle.measure = Measure::angle;
  const Family& family = *find_family("fresnel-quadratic");
  const Fit by_cosine = family.fit({}, minimax()), by_angle = family.fit({}, angle);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_TRUE(
        is_close("parameter", Decimal50(by_cosine.parameters[i]), by_angle.parameters[i], minimax_promise));
  EXPECT_NE(by_cosine.rms_error, by_angle.rms_error);
  EXPECT_EQ(describe(minimax()), describe(angle));
}

// An exact end, and bounds far from the optimum, change nothing. An active bound is met with equality.
TEST(Minimax, Constraints) {
  const Family& family = *find_family("fresnel-quadratic");
  const Fit free = family.fit({}, minimax());
  Metric idle = minimax();
  idle.constraints = {.exact_at = {0}, .at_most = 1, .at_least = 0};
  const Fit same = family.fit({}, idle);
  ASSERT_EQ(same.status, Status::converged) << same.why;
  EXPECT_EQ(same.parameters, free.parameters);

  // s (1-c)^4 is exact at grazing for s = 1; c (1-c)^4 is largest at c = 1/5.
  Metric exact = minimax();
  exact.constraints.exact_at = {0};
  const Fit fourth = find_family("fresnel-fourth")->fit({}, exact);
  ASSERT_EQ(fourth.status, Status::converged) << fourth.why;
  EXPECT_NEAR(fourth.parameters[0], 1, 1e-15);
  EXPECT_NEAR(*fourth.level, 256.0 / 3125, 1e-15);
  EXPECT_EQ(std::count_if(fourth.alternation.begin(), fourth.alternation.end(),
                          [](const AlternationPoint& p) { return p.touch == Touch::exact; }),
            1);

  // Schlick's formula leaves c = 0 with slope -5: (a c + b) c may do no less, so b = -5/ln 2.
  Metric below = minimax();
  below.domain = {0, 0.5};
  below.constraints.one_sided = Side::below;
  const Fit tangent = family.fit({}, below);
  ASSERT_EQ(tangent.status, Status::converged) << tangent.why;
  EXPECT_TRUE(is_close("b", -5 / log(Decimal50(2)), tangent.parameters[1], minimax_promise));
  EXPECT_TRUE(std::any_of(tangent.alternation.begin(), tangent.alternation.end(),
                          [](const AlternationPoint& p) { return p.is_tangent && p.at.cos_theta == 0; }));
  EXPECT_LE(family.largest_error({}, below, tangent.parameters).magnitude, *tangent.level * (1 + 1e-12));
}

// The error of a sharp lobe is (x - 4) of the size of 1/k: steps far below 4 still count. As k grows, k level
// and k (x - 4) have limits.
TEST(Minimax, SmallStepsBesideALargeParameterCount) {
  const Family& blinn = *find_family("phong-blinn");
  const double level = 0.0628340625, off = 1.3254868;
  for (const double k : {1e7, 1e8, 1e10}) {
    const Fit fit = blinn.fit(k, minimax());
    ASSERT_EQ(fit.status, Status::converged) << k << " " << fit.why;
    EXPECT_NEAR(*fit.level * k / level, 1, 1e-6) << k;
    EXPECT_NEAR((fit.parameters[0] - 4) * k / off, 1, 1e-6 + 4e-16 * k) << k;
    EXPECT_NEAR(fit.max_abs_error.magnitude / *fit.level, 1, 1e-6 + 1e-15 * k) << k;
  }
}

// form = exp((k + x)(c - 1)) is least at c = 0, where form >= bound holds it; far from least squares, where
// the form is next to nothing at c = 0, its logarithm says how far. cos^(x k)(theta/2) is 2^(-x k/2) there.
TEST(Minimax, KeepsToLowerBoundsFarFromLeastSquares) {
  for (const double exponent : {36.6, 37.0, 50.0, 100.0}) {
    for (const char* bound : {"1e-6", "0.0087", "0.2", "0.9"}) {
      Metric metric = minimax();
      metric.constraints.at_least = *parse_number(bound);
      const Decimal50 log_bound = log(Decimal50(bound));
      const std::string what = std::to_string(exponent) + " >= " + bound;
      const Fit gaussian = find_family("sg-offset")->fit(exponent, metric);
      const Fit blinn = find_family("phong-blinn")->fit(exponent, metric);
      ASSERT_EQ(gaussian.status, Status::converged) << what << " " << gaussian.why;
      EXPECT_TRUE(is_close(what, -log_bound - Decimal50(exponent), gaussian.parameters[0], minimax_promise));
      ASSERT_EQ(blinn.status, Status::converged) << what << " " << blinn.why;
      EXPECT_TRUE(is_close(what, -2 * log_bound / (exponent * log(Decimal50(2))), blinn.parameters[0],
                           minimax_promise));
    }
  }
  // A bound is met by a lobe with a scale too.
  Metric metric = minimax();
  metric.constraints.at_least = 0.0087;
  for (const double exponent : {8.0, 37.0, 100.0}) {
    const Fit scaled = find_family("sg-scaled")->fit(exponent, metric);
    ASSERT_EQ(scaled.status, Status::converged) << exponent << " " << scaled.why;
    EXPECT_NEAR(scaled.parameters[0] * std::exp(-exponent - scaled.parameters[1]), 0.0087, 1e-14);
  }
}

// Where the target falls to 0 within the domain no positive form stays below it. The target is 0 at one end;
// short of that end the form touches it there: the logarithm of form over target is convex.
TEST(Minimax, StaysBelowTheTarget) {
  Metric metric = minimax();
  metric.constraints.one_sided = Side::below;
  for (const double exponent : {0.5, 1.0, 5.74, 37.0, 100.0, 1000.0, 1e6}) {
    for (const char* id : {"sg-offset", "phong-blinn"}) {
      const Fit fit = find_family(id)->fit(exponent, metric);
      EXPECT_EQ(fit.status, Status::infeasible) << id << " " << exponent;
      EXPECT_EQ(fit.why, "no parameters keep the form <= target at c = 0") << id << " " << exponent;
    }
  }
  for (const char* id : {"fresnel-one-term", "fresnel-quadratic", "fresnel-cubic", "fresnel-quartic"}) {
    for (const Surface& surface : {Surface{}, exact_surface(1.5), exact_surface(1.5724, 7.7354)}) {
      const Fit fit = find_family(id)->fit({0, surface}, metric);
      EXPECT_EQ(fit.status, Status::infeasible) << id << " " << surface.ior << " " << fit.why;
      EXPECT_EQ(fit.why.substr(0, 40), "no parameters keep the form <= target at")
          << id << " " << surface.ior;
    }
  }
  metric.domain = {0.01, 1};
  for (const double exponent : {3.0, 20.0, 100.0}) {
    const Fit fit = find_family("sg-offset")->fit(exponent, metric);
    ASSERT_EQ(fit.status, Status::converged) << exponent << " " << fit.why;
    // (k + x)(c - 1) = k log c at c = 1/100
    const Decimal50 c(0.01);
    EXPECT_TRUE(is_close("x", exponent * (log(c) / (c - 1) - 1), fit.parameters[0], minimax_promise));
  }
}

TEST(Minimax, SaysWhatCannotBeSatisfied) {
  const auto expect_infeasible = [&](const char* id, const Constraints& constraints, const std::string& why) {
    Metric metric = minimax();
    metric.constraints = constraints;
    const Fit fit = find_family(id)->fit({}, metric);
    EXPECT_EQ(fit.status, Status::infeasible) << id << " " << describe(metric);
    EXPECT_EQ(fit.why, why) << id << " " << describe(metric);
  };
  expect_infeasible("fresnel-quadratic", {.exact_at = {1}}, "the form cannot be exact at c = 1");
  expect_infeasible("fresnel-quadratic", {.at_most = 0.9}, "no parameters keep the form <= 0.9 at c = 0");
  expect_infeasible("fresnel-quadratic", {.at_most = 0}, "no parameters keep the form <= 0 at c = 0");
  expect_infeasible("fresnel-quadratic", {.at_most = -1}, "no parameters keep the form <= -1 at c = 0");
  expect_infeasible("fresnel-square", {.at_least = 0.001}, "no parameters keep the form >= 0.001 at c = 1");
  expect_infeasible("fresnel-rational", {.at_least = 0.001}, "no parameters keep the form >= 0.001 at c = 1");
  expect_infeasible("fresnel-rational", {.at_least = 1}, "no parameters keep the form >= 1 at c = 1");
}

TEST(Minimax, DegenerateAlternationsAreNoAnswers) {
  Metric bounded = minimax();
  bounded.domain = {0.5, 1};
  bounded.constraints.at_most = 0.9;  // holds the error up at 1, and a place between holds nothing up
  EXPECT_EQ(find_family("sg-scaled")->fit(5, bounded).status, Status::degenerate);
}

TEST(Minimax, EndsWithAStatusWhateverIsAsked) {
  for (const double exponent : {1e-320, 1e-12, 1e12, 1e160}) {
    for (const char* id : {"sg-offset", "phong-blinn", "sg-scaled"}) {
      const Fit fit = find_family(id)->fit(exponent, minimax());
      EXPECT_EQ(fit.why.empty(), fit.status == Status::converged) << id << " " << exponent;
    }
  }
  for (const Domain domain : {Domain{0.5, 0.5000000000000001}, Domain{0, 1e-300}, Domain{0, 1e-12}}) {
    Metric metric = minimax();
    metric.domain = domain;
    EXPECT_NE(find_family("fresnel-quadratic")->fit({}, metric).status, Status::converged) << to_text(domain);
  }
}

TEST(LeastSquares, RelativeWeightedAndHeld) {
  // With b held at the free optimum's the other parameter is the free optimum's.
  const Family& family = *find_family("fresnel-quadratic");
  const Fit free = family.fit({}, {});
  const Fit held = family.fit({}, {.constraints = {.held = {{"b", free.parameters[1]}}}});
  ASSERT_EQ(held.status, Status::converged);
  ASSERT_EQ(held.parameters.size(), 1U);
  EXPECT_TRUE(is_close("a", Decimal50(free.parameters[0]), held.parameters[0], 1e-13));
  // The weight c^(1/2) makes the cosine measure the cosine-weighted one.
  const Fit weighted = family.fit({}, {.weight = "sqrt(c)"});
  const Fit measured = family.fit({}, {.measure = Measure::cosine_weighted});
  ASSERT_EQ(weighted.status, Status::converged);
  EXPECT_TRUE(is_close("a", Decimal50(measured.parameters[0]), weighted.parameters[0], 1e-12));
  // The relative error is the absolute one over F: a weight of 0.96/F says the same.
  const Fit relative = family.fit({}, {.error = Error::relative});
  const Fit divided = family.fit({}, {.weight = "0.96 / (0.04 + 0.96 (1 - c)^5)"});
  ASSERT_EQ(relative.status, Status::converged);
  EXPECT_EQ(relative.digits, 14);
  EXPECT_TRUE(is_close("a", Decimal50(divided.parameters[0]), relative.parameters[0], 1e-13));
  EXPECT_TRUE(is_close("b", Decimal50(divided.parameters[1]), relative.parameters[1], 1e-13));
  const auto largest = [&](const Fit& fit) {
    return family.largest_error({}, relative.metric, fit.parameters).magnitude;
  };
  EXPECT_LT(largest(relative), largest(free));
}

TEST(Metrics, DescribeThemselves) {
  Metric metric = minimax(Error::relative);
  EXPECT_EQ(describe(metric), "minimax relative error");
  metric.domain = {0.25, 1};
  metric.weight = "1 + 4 c";
  metric.constraints = {
      .held = {{"b", -7}}, .exact_at = {1}, .one_sided = Side::above, .at_most = 1, .at_least = 0};
  EXPECT_EQ(
      describe(metric),
      "minimax relative error on 0.25:1, weight 1 + 4 c, b = -7, exact at c = 1, form >= target, form <= 1, "
      "form >= 0");
  EXPECT_EQ(describe({.error = Error::relative}), "cosine, relative error");
}

}  // namespace
}  // namespace shadefit
