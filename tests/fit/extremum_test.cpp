#include "fit/extremum.hpp"

#include <gtest/gtest.h>

#include "fit/fit.hpp"
#include "tests/accuracy.hpp"

namespace shadefit {
namespace {

using testing::is_close;

const Substitution whole({}, {});

TEST(Extremum, FindsInteriorAndEnds) {
  const auto hump = [](const auto& c) { return c.cos_theta * c.one_minus_cos; };
  const auto interior = largest_magnitude(hump, whole);
  EXPECT_NEAR(interior.magnitude, 0.25, 1e-16);
  EXPECT_NEAR(interior.at.cos_theta, 0.5, 1e-12);
  EXPECT_EQ(largest_magnitude([](const auto& c) { return c.cos_theta; }, whole).at.cos_theta, 1);
  EXPECT_EQ(largest_magnitude([](const auto& c) { return -c.one_minus_cos; }, whole).at.cos_theta, 0);
  EXPECT_EQ(largest_magnitude([](const auto& c) { return -c.one_minus_cos; }, whole).magnitude, 1);
}

TEST(Extremum, OfEqualOnesTheSmallestCosine) {
  const auto equal = [](const auto& c) {
    using T = std::decay_t<decltype(c.cos_theta)>;
    const T m = c.cos_theta - integer<T>(1) / integer<T>(2);
    return m * (m * m - constant<T>("0.1875"));  // odd about 1/2: |f| = 1/32 at the ends and at m = +-1/4
  };
  const auto found = largest_magnitude(equal, whole);
  EXPECT_EQ(found.at.cos_theta, 0);
  EXPECT_NEAR(found.magnitude, 1.0 / 32, 1e-16);
}

// Reference: Sollya at 200 bits, and two 50-digit methods, for the published pair.
TEST(Extremum, PublishedFresnelPair) {
  const std::vector<double> pair{-5.55473, -6.98316};
  const auto found = find_family("fresnel-quadratic")->max_abs_error(0, {}, pair);
  // the error is a difference of numbers near 0.75: 1e-16 of them is 3e-14 of it
  EXPECT_TRUE(is_close("pair", Decimal50("3.7664127395073188128e-3"), found.magnitude, 1e-13));
  EXPECT_NEAR(found.at.cos_theta, 0.055357167992283370342, 1e-12);
}

// Against a dense scan, at the extremes of the promise.
TEST(Extremum, IsTheLargestOfADenseScan) {
  const FittableFamily& family = *find_family("sg-offset");
  for (const double k : {0.1, 1.0, 5.0, 100.0, 1e6}) {
    const Fit fit = family.fit(k, {});
    double largest = 0;
    for (int i = 0; i <= 100000; ++i) {
      const double y = std::min(1.0, 24 / k) * i / 100000;
      const double error =
          std::exp(-(k + fit.parameters[0]) * y) - (y < 1 ? std::exp(k * std::log1p(-y)) : 0);
      largest = std::max(largest, std::abs(error));
    }
    // a step of 2.4e-4 in k y misses an extremum by 3e-8 of it; the plain difference cancels to 1e-16
    // absolute
    EXPECT_NEAR(fit.max_abs_error.magnitude, largest, 1e-7 * largest + 2e-16) << k;
    EXPECT_GE(fit.max_abs_error.magnitude, largest - 2e-16) << k;
  }
}

}  // namespace
}  // namespace shadefit
