#include "fit/scalars/jet.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "fit/scalars/functions.hpp"
#include "fit/scalars/multiprecision.hpp"
#include "tests/accuracy.hpp"
#include "tests/decimal100.hpp"

namespace shadefit {
namespace {

using testing::is_close;

/// First and second derivative of f at x by nested Jets against central differences in 100 digits: with h =
/// 1e-20 they are right to about 40 and 30 digits.
template <class F>
void expect_derivatives(const std::string& what, double x, const F& f) {
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

/// The places for a function: an arc is inside its circle, and a remainder has a branch at one half.
std::vector<double> places_of(std::string_view name) {
  if (name == "asin" || name == "acos") return {-0.875, -0.25, 0.125, 0.96875};
  if (name == "log1p_remainder") return {-0.9, -0.51, -0.49, -0.01, 0.01, 0.49, 0.51, 2.0};
  return {0.125, 0.3, 0.7, 2.5};
}

TEST(Jet, DerivativesOfTheVocabulary) {
  const auto& functions = functions_of_one<double>;
  for (std::size_t i = 0; i < functions.size(); ++i) {
    const auto function = [&]<class T>(const T& x) { return functions_of_one<T>[i](x); };
    for (const double x : places_of(functions[i].name))
      expect_derivatives(std::string(functions[i].name), x, function);
  }
  for (const double x : places_of("power")) {
    expect_derivatives("atan2", x, []<class T>(const T& t) { return atan2(t * t, t - integer<T>(1)); });
    expect_derivatives("abs", x, [](const auto& t) { return abs(t * t - t); });
    expect_derivatives("power 5", x, [](const auto& t) { return power(t, 5); });
    expect_derivatives("power -2", x, [](const auto& t) { return power(t, -2); });
    expect_derivatives("power 2.5", x, []<class T>(const T& t) { return power(t, constant<T>("2.5")); });
    expect_derivatives("t^t", x, [](const auto& t) { return power(t, t); });
  }
}

TEST(Jet, SelectsWithItsDerivatives) {
  for (const double x : {0.2, 0.8}) {
    expect_derivatives("select", x, []<class T>(const T& t) {
      return select(less(t, constant<T>("0.5")), t * t, integer<T>(1) - t * t * t);
    });
    const auto other = []<class T>(const T& t) { return power(t, 3) + t / integer<T>(4); };
    expect_derivatives("min", x, [&](const auto& t) { return min(t * t, other(t)); });
    expect_derivatives("max", x, [&](const auto& t) { return max(t * t, other(t)); });
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
