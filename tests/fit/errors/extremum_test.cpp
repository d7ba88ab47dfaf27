#include "fit/errors/extremum.hpp"

#include <gtest/gtest.h>

#include "fit/catalogue/family.hpp"
#include "fit/catalogue/near_peak.hpp"
#include "tests/accuracy.hpp"

namespace shadefit {
namespace {

using testing::is_close;

const Substitution whole_range({}, {});

TEST(Extremum, FindsInteriorAndEnds) {
  const auto hump = [](const auto& c) { return c.cos_theta * c.one_minus_cos; };
  const auto interior = largest_magnitude(hump, whole_range);
  EXPECT_NEAR(interior.magnitude, 0.25, 1e-16);
  EXPECT_NEAR(interior.at.cos_theta, 0.5, 1e-12);
  EXPECT_EQ(largest_magnitude([](const auto& c) { return c.cos_theta; }, whole_range).at.cos_theta, 1);
  EXPECT_EQ(largest_magnitude([](const auto& c) { return -c.one_minus_cos; }, whole_range).at.cos_theta, 0);
  EXPECT_EQ(largest_magnitude([](const auto& c) { return -c.one_minus_cos; }, whole_range).magnitude, 1);
}

TEST(Extremum, OfEqualOnesTheSmallestCosine) {
  const auto equal = [](const auto& c) {
    using T = std::decay_t<decltype(c.cos_theta)>;
    const T m = c.cos_theta - integer<T>(1) / integer<T>(2);
    return m * (m * m - constant<T>("0.1875"));  // odd about 1/2: |f| = 1/32 at the ends and at m = +-1/4
  };
  const auto found = largest_magnitude(equal, whole_range);
  EXPECT_EQ(found.at.cos_theta, 0);
  EXPECT_NEAR(found.magnitude, 1.0 / 32, 1e-16);
}

// Twenty crests, each 1e-8 higher than the one before it towards c = 1: close neighbours must not add up to a
// smaller one.
TEST(Extremum, TiesAreWithTheLargestAndNotAmongEachOther) {
  const auto crests = [](const auto& c) {
    using T = std::decay_t<decltype(c.cos_theta)>;
    const T height = integer<T>(1) - constant<T>("0.0000002") * c.one_minus_cos;
    return height * cos(integer<T>(40) * pi<T>() * c.one_minus_cos);
  };
  const auto found = largest_magnitude(crests, whole_range);
  EXPECT_EQ(found.magnitude, 1);
  EXPECT_EQ(found.at.cos_theta, 1);
}

TEST(Extremum, SeesANarrowSpikeAtThePeak) {
  const auto spike = [](const auto& c) {
    using T = std::decay_t<decltype(c.cos_theta)>;
    const T t = constant<T>("1e9") * c.one_minus_cos;
    return t * exp(-t);
  };
  EXPECT_NEAR(largest_magnitude(spike, whole_range).magnitude, std::exp(-1.0), 1e-15);
}

// Reference: Sollya at 200 bits, and two 50-digit methods, for the published pair.
TEST(Extremum, PublishedFresnelPair) {
  const std::vector<double> pair{-5.55473, -6.98316};
  const auto found = find_family("fresnel-quadratic")->largest_error(0, {}, pair);
  // the error is a difference of numbers near 0.75: 1e-16 of them is 3e-14 of it
  EXPECT_TRUE(is_close("pair", Decimal50("3.7664127395073188128e-3"), found.magnitude, 1e-13));
  // a maximum has half of the digits of a double, and a parabola through values beside it two more
  EXPECT_NEAR(found.at.cos_theta, 0.055357167992283370342, 1e-9);
}

// Against a dense scan, at the extremes of the promise.
TEST(Extremum, IsTheLargestOfADenseScan) {
  const Family& family = *find_family("sg-offset");
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

// The relative error of the Gaussian at the place where the lobe has fallen to 1/255: 255 exp(-(k+x) y) - 1,
// with y = 1 - exp(-log(255)/k), in 50 digits.
TEST(Extremum, RelativeErrorOfTheLobe) {
  const Family& family = *find_family("sg-offset");
  const Metric relative{.error = Error::relative};
  for (const double k : {0.0079, 0.1, 1.0, 5.0, 1e6, 1e12, 1e15}) {
    const Fit fit = family.fit(k, {});
    const Extremum largest = family.largest_error(k, relative, fit.parameters);
    const Decimal50 y = -expm1(-log(Decimal50(255)) / k);
    // 255 exp(-(k+x)y) - 1 as expm1 of its logarithm: at large k the terms cancel to 1/k of themselves
    const Decimal50 truth = expm1(log(Decimal50(255)) - (k + Decimal50(fit.parameters[0])) * y);
    EXPECT_TRUE(is_close(std::to_string(k), truth, largest.magnitude, 1e-12));
    EXPECT_GE(largest.at.cos_theta, where_lobe_is_visible(k)->cos_theta);
  }
  EXPECT_FALSE(study_of(family, 1e-3, relative)) << "1/255 is reached at exp(-5541) only";
  EXPECT_EQ(family.fit(1e-3, {}).status, Status::converged);
}

}  // namespace
}  // namespace shadefit
