#include "approx/gloss.hpp"

#include <limits>

#include "fit/scalars/binary_logarithm.hpp"
#include "fit/scalars/multiprecision.hpp"
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
  EXPECT_EQ(decode_gloss(0.0, 10.0, 1.0), 2);
  EXPECT_EQ(decode_gloss(1.0, 10.0, 1.0), 2048);
}

TEST(Gloss, NormalisesByOneMultiplyAdd) {
  for (const double s : {0.5, 2.0, 2048.0}) {
    const Decimal50 fused =
        base_two_normalisation(base_two_power(Decimal50(s)), base_two_normalisation_factor<Decimal50>(),
                               game_normalisation(Decimal50(0)));
    EXPECT_LT(abs(fused - (Decimal50(s) + 2) / 8), 1e-45);
  }
}

TEST(MisprintedLogarithm, IsRightAtOnePlace) {
  const auto place = misprinted_log_is_right_at<Decimal50>();
  const auto excess = [](const Decimal50& a) { return Decimal50(misprinted_log_by_log2(a) - log(a)); };
  EXPECT_LT(abs(excess(place)), 1e-47);
  EXPECT_LT(excess(place / 2), 0);
  EXPECT_GT(excess(place * 2), 0);
  // its closed form
  for (const double a : {0.01, 1.0, 50.0}) {
    const Decimal50 line =
        (1 - ln2<Decimal50>()) * log2_by_squares(Decimal50(a)) + log2_by_squares(ln2<Decimal50>());
    EXPECT_LT(abs(excess(Decimal50(a)) - line), 1e-47);
  }
}

}  // namespace
}  // namespace shadefit
