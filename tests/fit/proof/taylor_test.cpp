#include "fit/proof/taylor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "fit/proof/enclosed_integral.hpp"
#include "fit/scalars/multiprecision.hpp"
#include "tests/intervals.hpp"

namespace shadefit {
namespace {

using testing::contains;
using Series = Taylor<12>;

/// f(a + h) against the sum of its series at a, with the remainder that the coefficients on [a, a + h] give.
template <class F>
void expect_series(const std::string& name, const F& f, const char* at, const char* step) {
  const Decimal100 a(at), h(step);
  const Interval place = constant<Interval>(at),
                 whole = Scalar<Interval>::hull(place, place + constant<Interval>(step));
  const Series here = f(Series::variable(place)), all = f(Series::variable(whole));
  const Interval x = constant<Interval>(step);
  Interval sum = all[12] * power(x, 12);
  for (int j = 0; j < 12; ++j) sum = sum + here[j] * power(x, j);
  EXPECT_TRUE(contains(sum, f(Decimal100(a + h)))) << name;
  EXPECT_LT(width_of(sum), 1e-6) << name << ": an interval so wide would hold anything";
}

TEST(Taylor, EveryFunctionOfTheVocabulary) {
  const auto check = [](const std::string& name, const auto& f) { expect_series(name, f, "0.3", "0.0625"); };
  check("exp", [](const auto& x) { return exp(x); });
  check("exp2", [](const auto& x) { return exp2(x); });
  check("expm1", [](const auto& x) { return expm1(x); });
  check("log", [](const auto& x) { return log(x); });
  check("log2", [](const auto& x) { return log2(x); });
  check("log1p", [](const auto& x) { return log1p(x); });
  check("log1p_remainder", [](const auto& x) { return log1p_remainder(x); });
  check("sqrt", [](const auto& x) { return sqrt(x); });
  check("sin", [](const auto& x) { return sin(x); });
  check("cos", [](const auto& x) { return cos(x); });
  check("atan", [](const auto& x) { return atan(x); });
  check("erfc", [](const auto& x) { return erfc(x); });
  check("quotient", [](const auto& x) { return sin(x) / (exp(x) + x * x); });
  const auto powers = [](const auto& x) {
    using T = std::decay_t<decltype(x)>;
    return power(x, constant<T>("2.5")) - power(x, 7) * pi<T>() + power(x, -2) * ln2<T>();
  };
  expect_series("powers", powers, "0.3", "0.015625");
}

TEST(Taylor, ConditionsThatCannotBeDecidedHaveNoSeries) {
  const auto wide = Series::variable(testing::span("0.25", "0.75"));
  const auto one_half = constant<Series>("0.5");
  EXPECT_FALSE(is_bounded(max(wide, one_half).value()));
  EXPECT_FALSE(is_bounded(positive_part(wide - one_half)[3]));
  EXPECT_TRUE(is_bounded(max(wide, constant<Series>("0.25"))[1])) << "they only touch";
  EXPECT_FALSE(is_bounded(log(Series::variable(testing::span("0", "0.5")))[1]));
}

/// Integrals with a known value, under each measure.
TEST(EnclosedIntegral, HoldsKnownValues) {
  const auto integral = [](const Metric& metric, const auto& f) {
    const auto one = [f]<class T>(const Cosine<T>& c) { return std::array{T(f(c))}; };
    return EnclosedIntegral<20, 1>(metric, {1e-20}).of(one).value()[0];
  };
  const auto square = []<class T>(const Cosine<T>& c) { return c.cos_theta * c.cos_theta; };
  const auto root = []<class T>(const Cosine<T>& c) { return sqrt(c.cos_theta); };
  const Decimal100 quarter_pi = atan(Decimal100(1));
  EXPECT_TRUE(contains(integral({}, square), Decimal100(1) / 3));
  EXPECT_TRUE(contains(integral({.measure = Measure::angle}, square), quarter_pi));
  EXPECT_TRUE(contains(integral({.measure = Measure::cosine_weighted}, square), Decimal100("0.25")));
  EXPECT_TRUE(contains(integral({.domain = {0.25, 0.375}}, square), Decimal100(27 - 8) / 3 / 512));
  const Interval angle_part = integral({.measure = Measure::angle, .domain = {0, 0.75}}, square);
  // asin(x)/2 - x sqrt(1 - x^2)/2 at x = 3/4
  const Decimal100 x("0.75"), cosine = sqrt(Decimal100(1) - x * x);
  EXPECT_TRUE(contains(angle_part, (atan(Decimal100(x / cosine)) - x * cosine) / 2));
  const Interval singular = integral({}, root);
  EXPECT_TRUE(contains(singular, Decimal100(2) / 3));
  EXPECT_LT(width_of(singular), 1e-19);
}

TEST(EnclosedIntegral, GivesUpWhereThereIsNone) {
  const auto pole = []<class T>(const Cosine<T>& c) { return std::array{T(integer<T>(1) / c.cos_theta)}; };
  EXPECT_FALSE((EnclosedIntegral<4, 1>({}, {1e-6}).of(pole)));
}

}  // namespace
}  // namespace shadefit
