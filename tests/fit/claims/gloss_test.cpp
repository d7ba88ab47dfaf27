#include "approx/gloss.hpp"

#include <limits>

#include "fit/scalars/binary_logarithm.hpp"
#include "fit/scalars/multiprecision.hpp"
#include "tests/fit/ledger/find_claim.hpp"
#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

TEST(BinaryLogarithm, IsTheOtherLibrarysToFiftyDigits) {
  const RootsOfTwo<Decimal50> roots;
  const double tolerance = 1000 * std::numeric_limits<Decimal50>::epsilon().convert_to<double>();
  for (const char* text : {"-700.5", "-1", "-0.1", "0", "0.3", "0.9999999", "1", "20.25", "700"}) {
    const auto x = constant<Decimal50>(text);
    const Decimal50 truth = boost::multiprecision::pow(Decimal50(2), x);
    EXPECT_LT(abs(roots.exp2(x) / truth - 1), tolerance) << text;
    EXPECT_LT(abs(log2_by_squares(truth) - x), tolerance * 2) << text;
  }
  EXPECT_EQ(roots.exp2(Decimal50(11)), 2048);
  EXPECT_EQ(log2_by_squares(Decimal50(2048)), 11);
  EXPECT_EQ(log2_by_squares(Decimal50(1)), 0);
  EXPECT_EQ(roots.exp2(Decimal50(-3)), Decimal50(1) / 8);
}

TEST(Gloss, DecodesToEitherPower) {
  // One constant more in the exponent is one division by ln 2 less.
  const Decimal50 ten = 10, one = 1;
  for (int i = 0; i <= 10; ++i) {
    const Decimal50 gloss = Decimal50(i) / 10;
    const Decimal50 fused = decode_gloss(gloss, ten, base_two_first(one));
    EXPECT_LT(abs(fused / base_two_power(decode_gloss(gloss, ten, one)) - 1), 1e-47);
    const Decimal50 c = 1 - gloss / 3, s = decode_gloss(gloss, ten, one);
    EXPECT_LT(abs(gaussian_lobe_base_two(c, fused) / exp(Decimal50(s * (c - 1))) - 1), 1e-43);
  }
}

TEST(MisprintedLogarithm, IsRightAtOnePlace) {
  const Claim& claim = *find_claim("log2-identity-first");
  EXPECT_NEAR(computed_number(claim, "log2(right_at ln2) - log(right_at)"), 0, 1e-45);
}

}  // namespace
}  // namespace shadefit
