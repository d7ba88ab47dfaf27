#include "fit/quadrature/integrate.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <utility>

namespace shadefit {
namespace {

// sqrt(x) on [0, b]: the integral is 2/3 b^1.5. Boost's own estimate is off by (b - a)/2; the wrapper's is
// not.
TEST(GaussKronrod, ErrorIsInTheUnitsOfTheValue) {
  const auto root = [](double x) { return std::sqrt(x); };
  for (const double b : {0.5, 2.0, 4.0, 100.0}) {
    const Integral coarse = gauss_kronrod(root, 0, b, 1);  // tolerance 1: one panel
    double unscaled = 0;
    boost::math::quadrature::gauss_kronrod<double, 31>::integrate(root, 0.0, b, 0, 0.0, &unscaled);
    EXPECT_NEAR(coarse.error / (unscaled * b / 2), 1, 1e-9) << b;
    const double truth = 2.0 / 3 * b * std::sqrt(b);
    EXPECT_LE(std::abs(coarse.value - truth), coarse.error) << b;
    // |K - G| scales with the integral itself, b^1.5: the same relative error on every interval
    EXPECT_NEAR(coarse.error / truth / (gauss_kronrod(root, 0, 1, 1).error * 1.5), 1, 1e-9) << b;
  }
}

TEST(BothRules, AgreeWithClosedFormsWithinTheirEstimates) {
  const auto check = [](double a, double b, double truth, const auto& f) {
    for (const Integral& integral : {gauss_kronrod(f, a, b, 1e-14), tanh_sinh(f, a, b, 1e-14)}) {
      EXPECT_LE(std::abs(integral.value - truth), integral.error + 1e-15 * std::abs(truth)) << truth;
      EXPECT_LE(integral.error, 1e-11 * std::abs(truth)) << truth;
      EXPECT_GE(integral.error, rounding_of(truth) * (1 - 1e-9)) << truth;
    }
  };
  check(0, 1, std::expm1(1.0), [](double x) { return std::exp(x); });
  check(0, 3, std::sin(3.0), [](double x) { return std::cos(x); });
  check(0, 1, std::atan(1.0), [](double x) { return 1 / (1 + x * x); });
}

// In a narrow interval Boost's own places round onto its ends, and an assertion fails. In an interval of
// denormals Boost throws.
TEST(TanhSinh, OfANarrowIntervalStaysWithin) {
  for (const auto& [a, b] :
       {std::pair(0.5, std::nextafter(0.5, 1.0)), std::pair(0.0, 1e-320), std::pair(0.0, 5e-324),
        std::pair(1 - 1e-10, 1.0), std::pair(0.7, 0.7 + 1e-15)}) {
    bool is_within = true;
    const double from = a, to = b;
    const auto f = [&](double x) {
      is_within = is_within && from <= x && x <= to;
      return 2.0;
    };
    const Integral found = tanh_sinh(f, a, b, 1e-12);
    EXPECT_TRUE(is_within) << a << " to " << b;
    EXPECT_NEAR(found.value, 2 * (b - a), 1e-12 * (b - a) + 5e-324) << a << " to " << b;
  }
}

// A negligible error is not refined: sqrt on [0, 1] is halved down to 1e-12, and not at all where 1e-3 will
// do.
TEST(GaussKronrod, RefinesNoFurtherThanAsked) {
  int calls = 0;
  const auto root = [&](double x) { return ++calls, std::sqrt(x); };
  gauss_kronrod(root, 0, 1, 1e-12);
  const int fine = calls;
  calls = 0;
  const Integral coarse = gauss_kronrod(root, 0, 1, 1e-12, 1e-3);
  EXPECT_LT(calls, 100);
  EXPECT_GT(fine, 500);
  EXPECT_LE(std::abs(coarse.value - 2.0 / 3), coarse.error);
}

// Infinite slopes at either end, halved many times by the one rule and met at the end by the other: the
// estimates hold.
TEST(BothRules, EstimatesHoldAtInfiniteSlopes) {
  const auto check = [](double truth, const auto& f) {
    for (const Integral& integral : {gauss_kronrod(f, 0, 1, 1e-12), tanh_sinh(f, 0, 1, 1e-12)}) {
      EXPECT_LE(std::abs(integral.value - truth), integral.error) << truth;
      // Fifteen halvings of x^0.1 leave (2^-15)^1.1 of a panel's error.
      EXPECT_LE(integral.error, 1e-8) << truth;
    }
  };
  check(2.0 / 3, [](double x) { return std::sqrt(x); });
  check(2.0 / 3, [](double x) { return std::sqrt(1 - x); });
  check(1 / 1.1, [](double x) { return std::pow(x, 0.1); });
}

}  // namespace
}  // namespace shadefit
