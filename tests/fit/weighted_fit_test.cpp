#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "fit/catalogue/family.hpp"
#include "fit/quadrature/integrate.hpp"

// The fits of families with a weight on the error.
namespace shadefit {
namespace {

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

/// The largest weighted error.
double largest_error_of(const Fit& fit) {
  return fit.family->largest_error(setting_of(fit), fit.metric, fit.parameters).magnitude;
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
    EXPECT_NEAR(fit.rms_error / std::sqrt(square(weight, fit.parameters)), 1, 1e-9) << weight.text;
    EXPECT_LE(fit.rms_error, largest_error_of(fit)) << weight.text;
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
    EXPECT_LE(fit.rms_error, largest_error_of(fit)) << weight.text;
  }
}

// What a weight is multiplied by does not change the curve: its errors are in the units of the weight.
TEST(WeightedFit, AConstantFactorChangesNoCurve) {
  for (const std::string_view id : {"fresnel-quadratic", "sg-offset", "fresnel-rational", "sg-scaled"}) {
    const Family& family = *find_family(id);
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
          EXPECT_NEAR(a.rms_error / b.rms_error, factor, 1e-12 * factor) << what;
          for (std::size_t i = 0; i < a.parameters.size(); ++i)
            EXPECT_NEAR(a.parameters[i] / b.parameters[i], 1, 1e-12) << what;
          if (a.level) {
            EXPECT_NEAR(*a.level / *b.level, factor, 1e-9) << what;
          }
          EXPECT_LE(a.rms_error, largest_error_of(a)) << what;
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

// On a surface the weight multiplies 1 - f0. The references were computed by MPFR and tanh-sinh integrals.
TEST(WeightedFit, OnASurface) {
  const Fit fit = find_family("fresnel-cubic")->fit({0, exact_surface(0.64, 4.11)}, {.weight = "exp(-c)"});
  ASSERT_EQ(fit.status, Status::converged) << fit.why;
  const std::vector<double> references{-1871.368510, 108.9599734, -18.97611801};
  for (std::size_t i = 0; i < references.size(); ++i)
    EXPECT_NEAR(fit.parameters[i] / references[i], 1, 1e-9);  // their last digit
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
      // The means of c^2 dc and of c dc differ by their normalisation.
      EXPECT_NEAR(fit.rms_error / same.rms_error, std::sqrt(0.5), 1e-12) << id << " " << k;
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
