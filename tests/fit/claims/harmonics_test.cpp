#include "approx/harmonics.hpp"

#include <boost/math/special_functions/binomial.hpp>

#include "fit/scalars/multiprecision.hpp"
#include "tests/accuracy.hpp"
#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

using testing::is_close;

// 24 bytes * 1280 * 720 = 22118400: 22.1 million, 21.09 times 2^20.
TEST(HarmonicsClaims, AMegabyteHasTwoReadings) {
  const Claim& claim = *find_claim("sh-buffer-memory");
  EXPECT_NE(evaluate(claim).evidence.find("22118400 bytes"), std::string::npos);
}

TEST(HarmonicsClaims, ALittleIsAReading) {
  const Claim& claim = *find_claim("sh-linear-loss");
  EXPECT_EQ(evaluate(claim).computed, "energy kept = 7/8 and 127/128");
}

// P_l(x) = 2^-l sum over k of (-1)^k C(l, k) C(2 l - 2 k, l) x^(l - 2 k), so that the integral of x P_l(x)
// over [0, 1] is a sum of 1/(l - 2 k + 2).
TEST(Harmonics, MomentsOfTheClampedCosine) {
  for (unsigned l = 0; l <= 24; ++l) {
    Decimal50 sum = 0, value = 0;
    const Decimal50 x("0.3");
    for (unsigned k = 0; 2 * k <= l; ++k) {
      const Decimal50 coefficient = boost::math::binomial_coefficient<Decimal50>(l, k) *
                                    boost::math::binomial_coefficient<Decimal50>(2 * l - 2 * k, l) *
                                    (k % 2 == 0 ? 1 : -1) / power(Decimal50(2), static_cast<int>(l));
      sum += coefficient / (l - 2 * k + 2);
      value += coefficient * power(x, static_cast<int>(l - 2 * k));
    }
    const int band = static_cast<int>(l);
    // sums of terms up to 1e9: 40 digits are left
    EXPECT_TRUE(is_close(std::to_string(l), 1 + sum, 1 + clamped_cosine_moment<Decimal50>(band), 1e-38));
    EXPECT_TRUE(is_close(std::to_string(l), 1 + value, 1 + legendre_polynomial(band, x), 1e-38));
    EXPECT_EQ(legendre_polynomial(band, Decimal50(1)), 1);
  }
}

TEST(Harmonics, BandsAddUpToTheClampedCosine) {
  const auto moment = [](int band) { return clamped_cosine_moment<double>(band); };
  EXPECT_EQ(energy_of_band(0, moment(0)), 0.375);
  EXPECT_NEAR(energy_of_band(1, moment(1)), 0.5, 1e-15);
  EXPECT_EQ(energy_of_band(2, moment(2)), 15.0 / 128);
  EXPECT_EQ(peak_of_band(2, moment(2)), 0.3125);
  double energy = 0, peak = 0;
  for (int band = 0; band < 400; ++band) {
    energy += energy_of_band(band, moment(band));
    peak += peak_of_band(band, moment(band));
  }
  // What the bands beyond n hold falls as n^-3, what they add at the peak alternates and falls as n^-1.5.
  EXPECT_LT(1 - energy, 1e-7);
  EXPECT_GT(1 - energy, 0);
  EXPECT_NEAR(peak, 1, 1e-4);
}

}  // namespace
}  // namespace shadefit
