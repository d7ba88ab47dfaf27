#include "fit/least_squares/weight.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "fit/fit.hpp"
#include "fit/quadrature/integrate.hpp"

namespace shadefit {
namespace {

std::string fault_of(const char* text, const Domain& domain = {}) {
  return find_fault(Weight(text, domain)).value_or("none");
}

TEST(Weight, IsAFormulaOfTheCosine) {
  EXPECT_TRUE(Weight().is_one());
  EXPECT_EQ(Weight("1 + 4 c").at(0.5), 3);
  EXPECT_EQ(Weight("sqrt(0.25 - c^2)", {0, 0.5}).at(0.6), 0) << "beyond an end the end stands for it";
  EXPECT_THROW(Weight("1 + k"), std::invalid_argument);
}

// The solvers ask for a weight in Jets of the place: the derivatives of sqrt(1 + c) are known.
TEST(Weight, HasTheDerivativesOfItsFormula) {
  using First = ceres::Jet<double, 1>;
  using Second = ceres::Jet<First, 1>;
  const Weight weight("sqrt(1 + c)");
  Second c(First(0.5625, 0));
  c.v[0] = First(1.0);
  const Second value = weight.at(c);
  EXPECT_EQ(value.a.a, 1.25);
  EXPECT_DOUBLE_EQ(value.a.v[0], 0.4);
  EXPECT_DOUBLE_EQ(value.v[0].a, 0.4);
  EXPECT_DOUBLE_EQ(value.v[0].v[0], -0.128);
  ceres::Jet<long double, 1> wide(0.5625L);
  wide.v[0] = 1;
  EXPECT_EQ(weight.at(wide).a, 1.25L);
  EXPECT_NEAR(static_cast<double>(weight.at(wide).v[0] - 0.4L), 0, 1e-19) << "long double";
  const TwoLanes both = weight.at(TwoLanes(0.5625, 0));
  EXPECT_EQ(both[0], 1.25);
  EXPECT_EQ(both[1], 1);
  // A place that a parameter does not move has no derivative by it, even where the slope is infinite.
  const ceres::Jet<double, 1> still = Weight("sqrt(c)").at(ceres::Jet<double, 1>(0.0));
  EXPECT_EQ(still.v[0], 0);
}

// A formula that is zero at single places can be a weight.
TEST(Weight, MayBeZeroAtSinglePlaces) {
  for (const char* text : {"1 + 4 c", "c", "1 - c", "c^2", "sqrt(1 - c*c)", "(c - 0.5)^2", "(c - 0.3)^2",
                           "1 - 2 c + c*c", "max(c, 0.1)", "max(c - 0.5, 0.5 - c)", "sqrt((c - 0.5)^2)",
                           "c^0.3", "(c < 0.5 ? 2 : 1)", "exp(-10000 c)", "max(c, 1)", "1 - exp(c - 1)"})
    EXPECT_EQ(fault_of(text), "none") << text;
  EXPECT_EQ(fault_of("c - 0.5", {0.5, 1}), "none");
  EXPECT_EQ(fault_of("1/c", {0.25, 1}), "none");
}

TEST(Weight, SaysWhyAFormulaIsNone) {
  EXPECT_EQ(fault_of("c - 0.5"), "is -0.5 at c = 0: it must not be negative over the domain");
  EXPECT_TRUE(fault_of("(c - 0.3)^2 - 0.000000001").starts_with("is -1e-09 at c = 0.3"));
  EXPECT_EQ(fault_of("1/c"), "is inf at c = 0: it must be finite over the domain");
  EXPECT_EQ(fault_of("sin(3 c)/c"), "is nan at c = 0: it must be finite over the domain");
  EXPECT_TRUE(fault_of("1/(c - 0.3)^2").starts_with("divides by zero at c = 0.3"));
  EXPECT_TRUE(fault_of("(c - 0.3)^(-2)").starts_with("divides by zero at c = 0.3"));
  EXPECT_TRUE(fault_of("1/(c*c - 0.5)^2").starts_with("divides by zero at c = 0.7071067811865"));
  EXPECT_EQ(fault_of("max(c - 0.5, 0)"), "is 0 from c = 0 to c = 0.5: it may be 0 at single places only");
  EXPECT_TRUE(fault_of("max((c - 0.5)^2 - 0.00000001, 0)").starts_with("is 0 from c = 0.4999 to c = 0.5001"))
      << "the kinks lie between two search places";
  EXPECT_EQ(fault_of("(1 + c) - 1 - c"), "is 0 from c = 0 to c = 1: it may be 0 at single places only");
  EXPECT_EQ(fault_of("0"), "is 0 from c = 0 to c = 1: it may be 0 at single places only");
  EXPECT_EQ(fault_of("1e200"), "is 1e+200 at its largest: that must lie between 1e-100 and 1e+100");
  EXPECT_EQ(fault_of("1e-200"), "is 1e-200 at its largest: that must lie between 1e-100 and 1e+100");
  EXPECT_TRUE(fault_of("max(sin(400 c), 0.5)").starts_with("has more than 64 kinks"));
}

TEST(Weight, FindsItsEdges) {
  const auto edges = [](const char* text) { return Weight(text).edges(); };
  EXPECT_TRUE(edges("1 + 4 c").empty());
  EXPECT_TRUE(edges("(c - 0.5)^2").empty());
  ASSERT_EQ(edges("max(c, 0.1)").size(), 1U);
  EXPECT_NEAR(edges("max(c, 0.1)")[0].above, 0.1, 2e-16);
  EXPECT_EQ(edges("max(c, 0.1)")[0].power, 1) << "smooth on either side";
  EXPECT_EQ(edges("max(c, 0.1) + max(0.1, c)").size(), 1U);
  EXPECT_EQ(edges("min(max(c, 0.1), 0.4)").size(), 2U);
  ASSERT_EQ(edges("sqrt(1 - c*c)").size(), 1U);
  EXPECT_EQ(edges("sqrt(1 - c*c)")[0].below, 1);
  EXPECT_GT(edges("sqrt(1 - c*c)")[0].power, 1);
  ASSERT_EQ(edges("sqrt((c - 0.3)^2)").size(), 1U) << "a root of what touches zero";
  EXPECT_NEAR(edges("sqrt((c - 0.3)^2)")[0].above, 0.3, 2e-16);
  // Of a choice each side keeps its own value at the edge.
  const Weight step("(c < 0.5 ? 2 : 1)");
  ASSERT_EQ(step.edges().size(), 1U);
  EXPECT_EQ(step.at(step.edges()[0].above), 1);
  EXPECT_EQ(step.at(step.edges()[0].below), 2);
}

/// A weight for the tests, also as C++ computes it, and where it has a kink.
struct Known {
  const char* text;
  double (*value)(double);
  double kink = 0.5;
};

const std::vector<Known> known_weights{
    {"10", [](double) { return 10.0; }},
    {"1 + 4 c", [](double c) { return 1 + 4 * c; }},
    {"sqrt(1 - c*c)", [](double c) { return std::sqrt(1 - c * c); }},
    {"c^2", [](double c) { return c * c; }},
    {"1 - c", [](double c) { return 1 - c; }},
    {"(c - 0.5)^2", [](double c) { return (c - 0.5) * (c - 0.5); }},
    {"max(c, 0.1)", [](double c) { return std::fmax(c, 0.1); }, 0.1},
    {"1 - min(c, 0.6)", [](double c) { return 1 - std::fmin(c, 0.6); }, 0.6},
    {"max(c - 0.5, 0.5 - c)", [](double c) { return std::abs(c - 0.5); }},
    {"sqrt((c - 0.3)^2)", [](double c) { return std::abs(c - 0.3); }, 0.3},
    {"(c < 0.5 ? 2 : 1)", [](double c) { return c < 0.5 ? 2.0 : 1.0; }},
    {"c^0.3", [](double c) { return std::pow(c, 0.3); }},
    {"(1 - c)^0.25", [](double c) { return std::pow(1 - c, 0.25); }},
};

double pair_error(double c, const std::vector<double>& p) {
  return std::exp2((p[0] * c + p[1]) * c) - std::pow(1 - c, 5);
}

/// The integral of a function of the cosine by another rule than a fit's, cut at the kink of a weight.
double integral(const Integrand& f, double kink) {
  return tanh_sinh(f, 0, kink, 1e-13).value + tanh_sinh(f, kink, 1, 1e-13).value;
}

/// Of the Fresnel pair, the integral of (weight * error)^2.
double square(const Known& weight, const std::vector<double>& p) {
  const auto f = [&](double c) { return std::pow(weight.value(c) * pair_error(c, p), 2); };
  return integral(f, weight.kink);
}

TEST(WeightedFit, LeastSquaresIsLeastByAnotherRule) {
  for (const Known& weight : known_weights) {
    const Fit fit = find_family("fresnel-quadratic")->fit({}, {.weight = weight.text});
    ASSERT_EQ(fit.status, Status::converged) << weight.text;
    EXPECT_EQ(fit.digits, 14) << weight.text;
    for (std::size_t i = 0; i < 2; ++i) {
      const double step = 1e-3;
      std::vector<double> more = fit.parameters, less = fit.parameters;
      more[i] += step;
      less[i] -= step;
      const double at = square(weight, fit.parameters), above = square(weight, more),
                   below = square(weight, less);
      // Newton's step by differences: what is left is their truncation, of the order of the step squared.
      EXPECT_LT(std::abs((above - below) / 2 / (above - 2 * at + below)) * step, 1e-5)
          << weight.text << " " << i;
    }
    const double mean = integral([&](double c) { return std::pow(weight.value(c), 2); }, weight.kink);
    EXPECT_NEAR(fit.rms_error / std::sqrt(square(weight, fit.parameters) / mean), 1, 1e-9) << weight.text;
    EXPECT_LE(fit.rms_error, fit.max_abs_error.magnitude) << weight.text;
  }
}

TEST(WeightedFit, MinimaxIsLevelEverywhere) {
  for (const Known& weight : known_weights) {
    const Fit fit = find_family("fresnel-quadratic")->fit({}, {.norm = Norm::minimax, .weight = weight.text});
    ASSERT_EQ(fit.status, Status::converged) << weight.text << ": " << fit.why;
    EXPECT_EQ(fit.digits, 14) << weight.text;
    double largest = 0;
    for (int i = 0; i <= 20000; ++i) {
      const double c = i / 20000.0;
      largest = std::fmax(largest, weight.value(c) * std::abs(pair_error(c, fit.parameters)));
    }
    EXPECT_LE(largest, *fit.level * (1 + 1e-9)) << weight.text;
    ASSERT_EQ(fit.alternation.size(), 3U) << weight.text;
    for (std::size_t i = 0; i < 3; ++i) {
      const AlternationPoint& point = fit.alternation[i];
      EXPECT_NEAR(std::abs(point.error) / *fit.level, 1, 1e-9) << weight.text;
      if (i > 0) {
        EXPECT_LT(point.error * fit.alternation[i - 1].error, 0) << weight.text;
      }
    }
    EXPECT_LE(fit.rms_error, fit.max_abs_error.magnitude) << weight.text;
  }
}

// What a weight is multiplied by changes neither the curve nor its rms error; the level of a minimax fit is
// in the units of the weight.
TEST(WeightedFit, AConstantFactorChangesNothing) {
  for (const std::string_view id : {"fresnel-quadratic", "sg-offset", "fresnel-rational", "sg-scaled"}) {
    const FittableFamily& family = *find_family(id);
    const Setting setting(family.has_exponent() ? 37.5 : 0);
    for (const Norm norm : {Norm::least_squares, Norm::minimax}) {
      for (const Error error : {Error::absolute, Error::relative}) {
        const auto fitted = [&](const char* weight) {
          return family.fit(setting, {.norm = norm, .error = error, .weight = weight});
        };
        const auto expect_same = [&](const Fit& a, const Fit& b, double factor) {
          const std::string what = std::string(id) + " " + describe(a.metric);
          ASSERT_EQ(a.status, Status::converged) << what;
          ASSERT_EQ(b.status, Status::converged) << what;
          EXPECT_NEAR(a.rms_error / b.rms_error, 1, 1e-12) << what;
          for (std::size_t i = 0; i < a.parameters.size(); ++i)
            EXPECT_NEAR(a.parameters[i] / b.parameters[i], 1, 1e-12) << what;
          if (a.level) {
            EXPECT_NEAR(*a.level / *b.level, factor, 1e-9) << what;
          }
          EXPECT_LE(a.rms_error,
                    error == Error::relative ? a.max_rel_error->magnitude : a.max_abs_error.magnitude)
              << what;
          const Metric metric = a.metric;
          EXPECT_NEAR(family.objective(setting, metric, a.parameters) / a.level.value_or(a.rms_error), 1,
                      1e-9)
              << what;
        };
        const Fit plain = fitted("");
        expect_same(fitted("1"), plain, 1);
        expect_same(fitted("2"), plain, 2);
        expect_same(fitted("10"), plain, 10);
        expect_same(fitted("10 + 40 c"), fitted("1 + 4 c"), 10);
      }
    }
  }
}

// The nodes that a root of the weight wants at c = 0 are not taken from the peak of a lobe.
TEST(WeightedFit, ARootFarFromThePeakTakesNoDigits) {
  for (const std::string_view id : {"sg-offset", "sg-scaled", "phong-blinn"}) {
    for (const double k : {1.5, 5.0, 12.5, 37.5}) {
      const Fit fit = find_family(id)->fit(k, {.weight = "sqrt(c)"});
      const Fit same = find_family(id)->fit(k, {.measure = Measure::cosine_weighted});
      ASSERT_EQ(fit.status, Status::converged) << id << " " << k;
      for (std::size_t i = 0; i < fit.parameters.size(); ++i)
        EXPECT_NEAR(fit.parameters[i] / same.parameters[i], 1, 1e-13) << id << " " << k;
      EXPECT_NEAR(fit.rms_error / same.rms_error, 1, 1e-12) << id << " " << k;
    }
  }
}

// A lobe of exponent k has fallen to 1e-21 where a fit without a weight ends its sums. With y = 1 - c a
// weight of y^8 has its largest share of the square not far from there.
TEST(WeightedFit, NothingIsCutOffThatAWeightRaises) {
  const double k = 10000;
  const Fit fit = find_family("sg-offset")->fit(k, {.weight = "(1 - c)^8"});
  ASSERT_EQ(fit.status, Status::converged);
  EXPECT_EQ(fit.digits, 14);
  const auto square_at = [&](double x) {
    // in t = k y; beyond t = 200 the square is below 1e-130 of its largest value
    const auto f = [&](double t) {
      const double y = t / k, error = std::exp(-(k + x) * y) - std::exp(k * std::log1p(-y));
      return std::pow(std::pow(t, 8) * error, 2);
    };
    return tanh_sinh(f, 0, 20, 1e-13).value + tanh_sinh(f, 20, 200, 1e-13).value;
  };
  const double x = fit.parameters[0], step = 1e-3 * std::abs(x);
  const double at = square_at(x), above = square_at(x + step), below = square_at(x - step);
  EXPECT_LT(std::abs((above - below) / 2 / (above - 2 * at + below)) * step, 1e-5 * std::abs(x));
}

}  // namespace
}  // namespace shadefit
