#include "fit/scalars/taylor.hpp"
#include "fit/proof/interval_ends.hpp"

#include <gtest/gtest.h>

#include <string>

#include "fit/scalars/multiprecision.hpp"
#include "tests/decimal100.hpp"
#include "tests/intervals.hpp"

namespace shadefit {
namespace {

using testing::contains;
using Series = Taylor<12, Interval>;

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
  check("exp", exp);
  check("exp2", exp2);
  check("expm1", expm1);
  check("log", log);
  check("log2", log2);
  check("log1p", log1p);
  check("log1p_remainder", log1p_remainder);
  check("sqrt", sqrt);
  check("sin", sin);
  check("cos", cos);
  check("atan", atan);
  check("erfc", erfc);
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

}  // namespace
}  // namespace shadefit
