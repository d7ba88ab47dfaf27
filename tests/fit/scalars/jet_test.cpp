#include "fit/scalars/jet.hpp"

#include <gtest/gtest.h>

#include "fit/scalars/multiprecision.hpp"
#include "tests/accuracy.hpp"

namespace shadefit {
namespace {

using testing::is_close;

/// First and second derivative of f at x by nested Jets against central differences in 100 digits: with h =
/// 1e-20 they are right to about 40 and 30 digits.
template <class F>
void expect_derivatives(const std::string& what, const F& f, double x) {
  using Inner = ceres::Jet<double, 1>;
  using Outer = ceres::Jet<Inner, 1>;
  Outer jet(Inner(x, 0));
  jet.v[0] = Inner(1.0);
  const Outer result = f(jet);

  const Decimal100 h("1e-20"), X(x);
  const Decimal100 above = f(Decimal100(X + h)), below = f(Decimal100(X - h)), here = f(X);
  const Decimal50 first((above - below) / (2 * h)), second((above - 2 * here + below) / (h * h));
  const std::string where = what + " at " + std::to_string(x);
  // A chain of a few roundings, amplified by at most 8 where terms of a derivative cancel in part.
  const double tolerance = 32 * std::numeric_limits<double>::epsilon();
  EXPECT_TRUE(is_close(where + ": value", Decimal50(here), result.a.a, tolerance));
  EXPECT_TRUE(is_close(where + ": first", first, result.v[0].a, tolerance));
  EXPECT_TRUE(is_close(where + ": inner first", first, result.a.v[0], tolerance));
  EXPECT_TRUE(is_close(where + ": second", second, result.v[0].v[0], tolerance));
}

TEST(Jet, DerivativesOfTheVocabulary) {
  for (const double x : {0.125, 0.3, 0.7, 2.5}) {
    expect_derivatives(
        "exp", [](const auto& t) { return exp(t); }, x);
    expect_derivatives(
        "exp2", [](const auto& t) { return exp2(t); }, x);
    expect_derivatives(
        "log", [](const auto& t) { return log(t); }, x);
    expect_derivatives(
        "log2", [](const auto& t) { return log2(t); }, x);
    expect_derivatives(
        "expm1", [](const auto& t) { return expm1(t); }, x);
    expect_derivatives(
        "log1p", [](const auto& t) { return log1p(t); }, x);
    expect_derivatives(
        "sqrt", [](const auto& t) { return sqrt(t); }, x);
    expect_derivatives(
        "sin", [](const auto& t) { return sin(t); }, x);
    expect_derivatives(
        "cos", [](const auto& t) { return cos(t); }, x);
    expect_derivatives(
        "atan", [](const auto& t) { return atan(t); }, x);
    expect_derivatives(
        "tan", [](const auto& t) { return tan(t); }, x);
    expect_derivatives(
        "sinh", [](const auto& t) { return sinh(t); }, x);
    expect_derivatives(
        "cosh", [](const auto& t) { return cosh(t); }, x);
    expect_derivatives(
        "tanh", [](const auto& t) { return tanh(t); }, x);
    expect_derivatives(
        "erf", [](const auto& t) { return erf(t); }, x);
    expect_derivatives(
        "atan2", [](const auto& t) { return atan2(t * t, t - integer<std::decay_t<decltype(t)>>(1)); }, x);
    expect_derivatives(
        "abs", [](const auto& t) { return abs(t * t - t); }, x);
    expect_derivatives(
        "power 5", [](const auto& t) { return power(t, 5); }, x);
    expect_derivatives(
        "power -2", [](const auto& t) { return power(t, -2); }, x);
    expect_derivatives(
        "power 2.5", [](const auto& t) { return power(t, constant<std::decay_t<decltype(t)>>("2.5")); }, x);
    expect_derivatives(
        "t^t", [](const auto& t) { return power(t, t); }, x);
  }
  for (const double x : {-0.875, -0.25, 0.125, 0.96875}) {
    expect_derivatives(
        "asin", [](const auto& t) { return asin(t); }, x);
    expect_derivatives(
        "acos", [](const auto& t) { return acos(t); }, x);
  }
  // both sides of the branch of log1p_remainder, and of zero
  for (const double x : {-0.9, -0.51, -0.49, -0.01, 0.01, 0.49, 0.51, 2.0}) {
    expect_derivatives(
        "log1p_remainder", [](const auto& t) { return log1p_remainder(t); }, x);
  }
}

TEST(Jet, SelectsWithItsDerivatives) {
  for (const double x : {0.2, 0.8}) {
    const auto tent = [](const auto& t) {
      using T = std::decay_t<decltype(t)>;
      return select(less(t, constant<T>("0.5")), t * t, integer<T>(1) - t * t * t);
    };
    expect_derivatives("select", tent, x);
    expect_derivatives(
        "min",
        [](const auto& t) { return min(t * t, power(t, 3) + t / integer<std::decay_t<decltype(t)>>(4)); }, x);
    expect_derivatives(
        "max",
        [](const auto& t) { return max(t * t, power(t, 3) + t / integer<std::decay_t<decltype(t)>>(4)); }, x);
  }
  using Jet = ceres::Jet<double, 1>;
  EXPECT_EQ(positive_part(Jet(-1, 0)).v[0], 0);
  EXPECT_EQ(positive_part(Jet(2, 0)).v[0], 1);
}

TEST(Jet, DerivativesAtTheEndsOfTheDomain) {
  using Jet = ceres::Jet<double, 1>;
  EXPECT_EQ(power(Jet(0, 0), Jet(2.5)).v[0], 0) << "0 * log 0 would be NaN";
  EXPECT_EQ(power(Jet(0, 0), Jet(1.0)).v[0], 1);
  EXPECT_TRUE(std::isinf(power(Jet(0, 0), Jet(0.5)).v[0])) << "the slope of a root at 0 is infinite, not NaN";
  EXPECT_EQ(power(Jet(1, 0), Jet(2.5)).v[0], 2.5);
  EXPECT_EQ(power(Jet(0, 0), 5).v[0], 0);
  EXPECT_EQ(log1p_remainder(Jet(0, 0)).v[0], 0);
  EXPECT_TRUE(std::isinf(sqrt(Jet(0, 0)).v[0]));
  EXPECT_TRUE(std::isinf(log(Jet(0, 0)).v[0]));
  EXPECT_TRUE(std::isinf(log1p(Jet(-1, 0)).v[0]));
  EXPECT_TRUE(std::isinf(log1p_remainder(Jet(-1, 0)).v[0]));
  EXPECT_EQ(power(Jet(0.0), Jet(0.5, 0)).v[0], 0) << "0^p stays 0 as p varies";
  EXPECT_EQ(power(Jet(0.0), Jet(2.5, 0)).v[0], 0);
}

TEST(Jet, WhatDoesNotVaryHasNoDerivativeWhereTheSlopeIsInfinite) {
  using Jet = ceres::Jet<double, 1>;
  EXPECT_EQ(sqrt(Jet(0.0)).v[0], 0);
  EXPECT_EQ(log(Jet(0.0)).v[0], 0);
  EXPECT_EQ(log2(Jet(0.0)).v[0], 0);
  EXPECT_EQ(log1p(Jet(-1.0)).v[0], 0);
  EXPECT_EQ(log1p_remainder(Jet(-1.0)).v[0], 0);
  EXPECT_EQ(power(Jet(0.0), Jet(0.5)).v[0], 0);
}

TEST(Jet, SecondDerivativesWhereTheFirstIsZero) {
  using Inner = ceres::Jet<double, 1>;
  using Outer = ceres::Jet<Inner, 1>;
  const auto at = [](double x) {
    Outer t(Inner(x, 0));
    t.v[0] = Inner(1.0);
    return t;
  };
  const auto two = lift<Outer>(2.0), half = lift<Outer>(0.5);
  // d^2/dt^2 of 0.5^(2 + t^2) at 0 is 2 ln(0.5) / 4: the exponent has no first derivative, but a second one
  EXPECT_NEAR(power(half, two + at(0) * at(0)).v[0].v[0], std::log(0.5) / 2, 1e-16);
  EXPECT_EQ(power(at(0), lift<Outer>(1.0)).v[0].v[0], 0) << "t^1 is straight";
  EXPECT_EQ(power(at(0), lift<Outer>(2.0)).v[0].v[0], 2);
  EXPECT_EQ(power(at(0), lift<Outer>(3.0)).v[0].v[0], 0);
}

TEST(Lift, KeepsValuesAndHasNoDerivatives) {
  using Nested = ceres::Jet<ceres::Jet<long double, 2>, 2>;
  const auto x = lift<Nested>(0.1L);
  EXPECT_EQ(x.a.a, 0.1L);
  EXPECT_EQ(x.a.v[1], 0);
  EXPECT_EQ(x.v[1].a, 0);
  EXPECT_EQ(lift<double>(0.5L), 0.5);
  EXPECT_EQ(lift<double>(0.1), 0.1);
}

}  // namespace
}  // namespace shadefit
