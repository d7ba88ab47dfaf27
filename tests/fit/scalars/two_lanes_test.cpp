#include "fit/scalars/two_lanes.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "fit/errors/ulps.hpp"

namespace shadefit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void expect_lanes(const TwoLanes& x, double first, double second) {
  EXPECT_EQ(x[0], first);
  EXPECT_EQ(x[1], second);
}

/// A function of the vocabulary in both arithmetics, its test range, and its bound in ulps.
struct Function {
  std::string name;
  std::function<TwoLanes(const TwoLanes&)> in_lanes;
  std::function<Decimal50(const Decimal50&)> in_fifty_digits;
  double from, to;
  double most_ulps;
};

/// The bounds are what was measured at 2e5 places, and a tenth: half an ulp is the last rounding's, the rest
/// of the argument's reduction and of the sum. A series that is cut one term too early, or a log(2) without
/// its lower part, is beyond them.
std::vector<Function> functions() {
  return {{"exp", exp, exp, -700, 700, 1.1},
          {"exp2", exp2, exp2, -1021, 1023, 1.2},
          {"expm1", expm1, expm1, -40, 40, 2.2},
          {"expm1 near 0", expm1, expm1, -0.5, 0.5, 2.2},
          {"log1p_remainder", log1p_remainder, log1p_remainder, -0.5, 0.5, 2.8},
          {"log1p_remainder near 0", log1p_remainder, log1p_remainder, -1e-3, 1e-3, 2.8},
          {"log1p_remainder far off", log1p_remainder, log1p_remainder, -0.999, 20, 3.2}};
}

TEST(TwoLanes, FunctionsAreThoseOfFiftyDigits) {
  for (const Function& f : functions()) {
    double worst = 0, at = 0;
    for (int i = 0; i < 2000; ++i) {
      // steps of the golden ratio, another place in each lane
      const auto place = [&](double n) {
        const double turns = n * 0.6180339887498949;
        return f.from + (f.to - f.from) * (turns - std::floor(turns));
      };
      const TwoLanes x(place(i), place(i + 0.5));
      const TwoLanes y = f.in_lanes(x);
      for (std::size_t lane = 0; lane < 2; ++lane) {
        const double off = ulps_off(y[lane], f.in_fifty_digits(Decimal50(x[lane])), double_format);
        if (off > worst) worst = off, at = x[lane];
      }
    }
    EXPECT_LE(worst, f.most_ulps) << f.name << " at " << at << ", error/tolerance " << worst / f.most_ulps;
    EXPECT_GT(worst, 0) << f.name;
  }
}

// The lanes are independent: exchanged arguments give exchanged results.
TEST(TwoLanes, LanesAreApart) {
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
  for (const double a : {-800.0, -1.5, 0.0, 0.25, 3.0, 900.0, infinity, std::nan("")}) {
    for (const double b : {-40.0, -0.125, 1e-300, 0.5, 700.0}) {
      for (const auto& f :
           {+[](const TwoLanes& x) { return exp(x); }, +[](const TwoLanes& x) { return exp2(x); },
            +[](const TwoLanes& x) { return expm1(x); }}) {
        const TwoLanes y = f({a, b}), z = f({b, a});
        EXPECT_EQ(bits(y[0]), bits(z[1])) << a << " beside " << b;
        EXPECT_EQ(bits(y[1]), bits(z[0])) << b << " beside " << a;
      }
    }
  }
}

TEST(TwoLanes, BeyondTheFormat) {
  expect_lanes(exp(TwoLanes(-1000, 1000)), 0, infinity);
  expect_lanes(exp2(TwoLanes(-2000, 2000)), 0, infinity);
  expect_lanes(expm1(TwoLanes(-1000, 0)), -1, 0);
  // a solver that steps there must see the NaN
  EXPECT_FALSE(std::isfinite(expm1(TwoLanes(0, 1000))[1]));
  for (const TwoLanes& y :
       {exp(TwoLanes(std::nan(""), 0)), exp2(TwoLanes(std::nan(""), 0)), expm1(TwoLanes(std::nan(""), 0))}) {
    EXPECT_TRUE(std::isnan(y[0]));
    EXPECT_TRUE(std::isfinite(y[1]));
  }
}

TEST(TwoLanes, ChoosesByLane) {
  int left = 0, right = 0;
  const auto chosen = [&](const TwoLanes& a, const TwoLanes& b) {
    left = right = 0;
    return choose(
        less(a, b), [&] { return ++left, TwoLanes(1, 2); }, [&] { return ++right, TwoLanes(3, 4); });
  };
  const TwoLanes both = chosen({0, 0}, {1, 1}), none = chosen({1, 1}, {0, 0});
  expect_lanes(both, 1, 2);
  expect_lanes(none, 3, 4);
  EXPECT_EQ(left, 0);  // where both lanes agree, the other branch is not computed
  const TwoLanes mixed = chosen({0, 1}, {1, 0});
  expect_lanes(mixed, 1, 4);
  EXPECT_EQ(left + right, 2);
  expect_lanes(min(TwoLanes(1, 4), TwoLanes(2, 3)), 1, 3);
  expect_lanes(max(TwoLanes(1, 4), TwoLanes(2, 3)), 2, 4);
}

}  // namespace
}  // namespace shadefit
