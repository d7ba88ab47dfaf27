#include "approx/lobe.hpp"

#include <cmath>
#include <vector>

#include "approx/lobe_laws.hpp"
#include "fit/claims/lobe_errors.hpp"
#include "fit/ledger/where.hpp"
#include "fit/quadrature/integrate.hpp"
#include "fit/scalars/multiprecision.hpp"
#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

/// The largest difference of c^k and the Gaussian in 50 digits: of a fine comb, its best place refined by
/// thirds.
Decimal50 largest_error_in_fifty_digits(const Decimal50& k, const Decimal50& x) {
  const auto difference = [&](const Decimal50& y) {
    return Decimal50(abs(exp(Decimal50(-(k + x) * y)) - power(Decimal50(1 - y), k)));
  };
  const Decimal50 width = min(Decimal50(1), Decimal50(30 / k));
  constexpr int teeth = 300;
  Decimal50 best = 0;
  for (int i = 0; i <= teeth; ++i) {
    const Decimal50 y = width * i / teeth;
    if (difference(y) > difference(best)) best = y;
  }
  Decimal50 low = max(Decimal50(0), Decimal50(best - width / teeth)),
            high = min(Decimal50(1), Decimal50(best + width / teeth));
  for (int i = 0; i < 80; ++i) {
    const Decimal50 third = (high - low) / 3;
    if (difference(low + third) < difference(high - third)) {
      low += third;
    } else {
      high -= third;
    }
  }
  return max(difference(best), difference(low));
}

TEST(LobeErrors, AreThoseOfFiftyDigits) {
  for (const double k : {0.5, 1.0, 2.0, 5.0, 14.0, 300.0}) {
    for (const double x : {0.0, 0.775, 1.0}) {
      const double truth = largest_error_in_fifty_digits(k, x).convert_to<double>();
      EXPECT_NEAR(largest_lobe_error(k, x).magnitude, truth, 1e-12 * truth) << "k = " << k << ", x = " << x;
    }
  }
}

TEST(LobeErrors, FollowTheirLaw) {
  for (const double x : {0.0, 0.75, 0.775, 1.0, 3.0})
    EXPECT_NEAR(1e6 * largest_lobe_error(1e6, x).magnitude, largest_error_law(x), 1e-5) << x;
  EXPECT_NEAR(largest_error_law(0.0), 2 * std::exp(-2.0), 1e-15);
}

TEST(LobeErrors, FallAsTheExponentGrows) {
  // What the thresholds of the plain form rest on, in absolute terms and in codes.
  for (double k = 0.1; k < 1e5; k *= 1.7) {
    EXPECT_GT(largest_lobe_error(k, 0).magnitude, largest_lobe_error(1.7 * k, 0).magnitude) << k;
    EXPECT_GT(largest_lobe_codes(k, 0), largest_lobe_codes(1.7 * k, 0)) << k;
    EXPECT_GT(largest_offset_codes(k, 0, 1), largest_offset_codes(1.7 * k, 0, 1)) << k;
  }
}

TEST(LobeErrors, NoOffsetHasALessLargestErrorThanTheSmallest) {
  for (const double k : {0.5, 1.0, 2.0, 3.0, 100.0}) {
    const auto [offset, error] = smallest_lobe_error(k);
    EXPECT_NEAR(largest_lobe_error(k, offset).magnitude, error, 1e-9);
    for (const double other : {0.0, offset - 1e-3, offset + 1e-3, 1.0, *best_offset(k)})
      EXPECT_GT(largest_lobe_error(k, other).magnitude, error) << k << " " << other;
  }
}

TEST(WidestGap, IsWhatASearchFinds) {
  for (const double k : {0.1, 1.0, 10.0, 1e4}) {
    for (const double x : {0.775, 1.0, 40.0}) {
      const Extremum found = largest_offset_difference(k, 0, x);
      EXPECT_NEAR(found.magnitude, widest_gap(k, k + x), 1e-13) << k << " " << x;
      EXPECT_NEAR(found.at.one_minus_cos, widest_gap_at(k, k + x), 1e-6) << k << " " << x;
    }
  }
  EXPECT_EQ(widest_gap_at(0.1, 1.1), 1) << "beyond the horizon";
  EXPECT_NEAR(1e6 * widest_gap(1e6, 1e6 + 1), std::exp(-1.0), 1e-6) << "its law";
}

TEST(PeakCrossing, IsWhereBothErrorsAreEqual) {
  for (const double k : {0.2, 1.0, 1.6, 5.0, 15.0, 1e4}) {
    for (const double x : {0.1, 0.775, 1.0}) {
      const auto c = peak_crossing(k, x);
      ASSERT_TRUE(c);
      // in 50 digits, from the cosine where that is the smaller
      const Decimal50 y =
          c->one_minus_cos < c->cos_theta ? Decimal50(c->one_minus_cos) : 1 - Decimal50(c->cos_theta);
      const Decimal50 target = power(Decimal50(1 - y), Decimal50(k));
      const Decimal50 plain = exp(Decimal50(-k * y)) - target,
                      shifted = exp(Decimal50(-(Decimal50(k) + Decimal50(x)) * y)) - target;
      EXPECT_GT(plain, 0);
      EXPECT_NEAR(Decimal50(shifted / plain).convert_to<double>(), -1, 1e-9 * k) << k << " " << x;
    }
  }
  EXPECT_FALSE(peak_crossing(5, 0));
  EXPECT_FALSE(peak_crossing(5, -1));
}

TEST(PeakCrossing, FollowsItsLaw) {
  for (const double x : {0.5, 0.775, 1.0}) {
    const auto law = peak_crossing_law(x);
    for (const double k : {1e3, 1e5})
      EXPECT_NEAR(k * peak_crossing(k, x)->one_minus_cos, law.limit + law.slope / k, 2 / (k * k)) << x;
  }
}

TEST(BluntOffsetLaw, IsTheRatioOfItsIntegrals) {
  const auto slope = [](const auto& weight) {
    const auto moment = [&](const auto& f) {
      return tanh_sinh([&](double theta) { return f(std::cos(theta)) * weight(theta); }, 0, std::acos(0.0),
                       1e-12)
          .value;
    };
    const auto log_moment = [](double c) { return c > 0 ? -std::log(c) * (1 - c) : 0; };
    return blunt_offset_slope(moment(log_moment), moment([](double c) { return (1 - c) * (1 - c); }));
  };
  const auto sine = [](double theta) { return std::sin(theta); };
  EXPECT_NEAR(blunt_offset_slope_cosine<double>(), slope(sine), 1e-9);
  EXPECT_NEAR(blunt_offset_slope_angle<double>(), slope([](double) { return 1.0; }), 1e-9);
  EXPECT_NEAR(blunt_offset_slope_cosine_weighted<double>(),
              slope([](double theta) { return std::sin(theta) * std::cos(theta); }), 1e-9);
}

TEST(BluntOffsetLaw, IsWhereTheFitsGo) {
  EXPECT_NEAR(*best_offset(1e-4) / 1e-4, blunt_offset_slope_cosine<double>(), 1e-3);
  EXPECT_NEAR(*best_offset(1e-4, Measure::angle) / 1e-4, blunt_offset_slope_angle<double>(), 1e-3);
  EXPECT_NEAR(*best_offset(1e-4, Measure::cosine_weighted) / 1e-4,
              blunt_offset_slope_cosine_weighted<double>(), 1e-3);
}

TEST(OffsetRange, KnowsWhereTheLawsDoNotHold) {
  EXPECT_TRUE(offset_range(Measure::cosine, {0.001, 1, 5, 100})->laws_hold);
  const auto range = offset_range(Measure::cosine, {1, 2, 3, 4, 5});
  EXPECT_NEAR(range->highest, 0.7957, 1e-4);
  EXPECT_NEAR(range->highest_at, 3.31, 0.01);
  EXPECT_FALSE(range->is_within(0.1, 1)) << "blunt lobes lead to 0";
  EXPECT_TRUE(range->is_within(0, 0.7958));
  EXPECT_FALSE(range->is_within(0, 0.7956));
}

TEST(OffsetOne, KeepsTheIntegralOfTheLobe) {
  for (const double k : {1.0, 5.0, 100.0}) {
    const double gaussian =
        gauss_kronrod([&](double c) { return gaussian_lobe(c, k, 1.0); }, 0, 1, 1e-13).value;
    const double lobe = gauss_kronrod([&](double c) { return power_lobe(c, k); }, 0, 1, 1e-13).value;
    EXPECT_NEAR(gaussian / lobe, 1 - std::exp(-(k + 1)), 1e-12) << k;
  }
}

TEST(Exponents, AreCutWhereAConditionBeginsAndEnds) {
  const auto exponents = doubling_exponents(1, 100);
  EXPECT_EQ(exponents, (std::vector<double>{1, 2, 4, 8, 16, 32, 64, 100}));
  const auto above = where_positive([](double k) { return k - 10; }, exponents);
  ASSERT_EQ(above.size(), 1U);
  EXPECT_NEAR(above[0].from, 10, 1e-8);
  EXPECT_EQ(above[0].to, 100);
  EXPECT_EQ(sentence(above, exponents), "from k = 10 on");
  EXPECT_TRUE(covers(above, 10.1, 100));
  EXPECT_FALSE(covers(above, 9.9, 100));
  const auto outside = where_positive([](double k) { return (k - 3) * (k - 50); }, exponents);
  EXPECT_EQ(sentence(outside, exponents), "up to k = 3 and from k = 50 on");
  EXPECT_FALSE(covers(outside, 1, 100));
  const auto inside = where_positive([](double k) { return (3 - k) * (k - 50); }, exponents);
  EXPECT_EQ(sentence(inside, exponents), "for k from 3 to 50");
  EXPECT_EQ(sentence(where_positive([](double) { return 1.0; }, exponents), exponents), "for every k");
  EXPECT_EQ(sentence(where_positive([](double) { return -1.0; }, exponents), exponents), "for no k");
  EXPECT_EQ(exponent_text(100000), "100000");
  EXPECT_EQ(exponent_text(8.06660), "8.067");
}

}  // namespace
}  // namespace shadefit
