#include <boost/math/special_functions/binomial.hpp>

#include "fit/scalars/multiprecision.hpp"
#include "tests/fit/ledger/find_claim.hpp"
#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

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
    Claim claim = *find_claim("sh-linear-loss");
    const std::string places = "l in " + std::to_string(l) + " .. " + std::to_string(l);
    const std::string with_cosine = places + ", c in 0.3 .. 0.3", at_peak = places + ", c in 1 .. 1";
    auto& definitions = claim.instructions.definitions;
    definitions.push_back({"of_band", "most", places, "moment"});
    definitions.push_back({"of_cosine", "most", with_cosine, "P"});
    definitions.push_back({"of_peak", "most", at_peak, "P"});
    EXPECT_NEAR(computed_number(claim, "of_band"), static_cast<double>(sum), 1e-15) << l;
    EXPECT_NEAR(computed_number(claim, "of_cosine"), static_cast<double>(value), 1e-14) << l;
    EXPECT_NEAR(computed_number(claim, "of_peak"), 1, 1e-14) << l;
  }
}

TEST(Harmonics, BandsAddUpToTheClampedCosine) {
  const Claim claim = with_input(*find_claim("sh-linear-loss"), "more coefficients", "900");
  // What the bands beyond n hold falls as n^-3, what they add at the peak alternates and falls as n^-1.5.
  const double rest = computed_number(claim, "1 - more");
  EXPECT_LT(rest, 3e-4);
  EXPECT_GT(rest, 0);
  EXPECT_NEAR(computed_number(claim, "more_height"), 1, 1e-2);
}

}  // namespace
}  // namespace shadefit
