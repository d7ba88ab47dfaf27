#include "approx/arithmetic.hpp"

#include <cmath>

#include "approx/lobe.hpp"
#include "fit/errors/banding.hpp"
#include "fit/ledger/formats.hpp"
#include "fit/scalars/multiprecision.hpp"
#include "fit/scalars/narrow_result.hpp"
#include "tests/fit/ledger/find_claim.hpp"
#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

// Independent of any exp of the format: the value rounds to zero below half of the least number 2^-m, that is
// for k > (m + 1) ln 2, and to a subnormal below (1 - 2^-p / 2) 2^-n.
TEST(GaussianAtZero, UnderflowsWhereTheLogarithmsSay) {
  const auto last = [](const char* format, std::string_view definition) {
    Claim claim = with_input(*find_claim("sg-nonzero-at-zero"), "formats", format);
    claim.instructions.definitions.push_back({"exponent", "most", "f in formats", definition});
    return computed_number(claim, "exponent");
  };
  const auto next = [](const char* format, double k) {
    return in_format(format, [&]<class T>() {
      double step = k;
      while (widened(rounded_to<T>(k + step / 2)) > k) step /= 2;
      return widened(rounded_to<T>(k + step));
    });
  };
  struct Format {
    const char* name;
    int least, normal, digits;
  };
  for (const Format& f : {Format{"half", 24, 14, 11}, {"float", 149, 126, 24}, {"double", 1074, 1022, 53}}) {
    const Decimal50 ln2 = Scalar<Decimal50>::ln2();
    const Decimal50 zero = (f.least + 1) * ln2;
    EXPECT_LT(Decimal50(last(f.name, "above")), zero) << f.name;
    EXPECT_GT(Decimal50(next(f.name, last(f.name, "above"))), zero) << f.name;
    // half a step of the subnormals below the least normal number still rounds up to it
    const Decimal50 flushed = f.normal * ln2 - log1p(Decimal50(-std::ldexp(1.0, -f.digits)));
    EXPECT_LT(Decimal50(last(f.name, "normal")), flushed) << f.name;
    EXPECT_GT(Decimal50(next(f.name, last(f.name, "normal"))), flushed) << f.name;
  }
}

TEST(Formats, ALastThatHoldsIsTheLastNumberOfTheFormat) {
  EXPECT_EQ(last_that_holds<Eigen::half>(1, 4, [](Eigen::half x) { return widened(x) <= 2.5003; }), 2.5);
  EXPECT_EQ(last_that_holds<double>(0, 1, [](double x) { return x < 0.25; }), std::nextafter(0.25, 0.0));
  EXPECT_EQ(last_that_holds<float>(0, 1, [](float) { return false; }), 0);
}

TEST(ExponentialForms, AreTheLobesThatTheyStandFor) {
  for (const char* c : {"0.125", "0.75", "0.9990234375"}) {
    for (const char* k : {"1", "12.5", "1024"}) {
      const auto cosine = constant<Decimal50>(c), exponent = constant<Decimal50>(k);
      const Decimal50 sharpness = base_two_power(exponent);
      const Decimal50 gaussian = exp(exponent * (cosine - 1));
      EXPECT_LT(abs(power_by_exp2(cosine, exponent) / pow(cosine, exponent) - 1), Decimal50("1e-44"));
      EXPECT_LT(abs(gaussian_lobe_base_two(cosine, sharpness) / gaussian - 1), Decimal50("1e-44"));
      EXPECT_LT(abs(gaussian_lobe_base_two_of_difference(cosine, sharpness) / gaussian - 1),
                Decimal50("1e-44"));
    }
  }
}

double jump_at_half_cosine(double exponent) {
  const HalfResult k = HalfResult::rounded(exponent);
  return banding(
             halves_near_the_peak(),
             [&](double c) { return static_cast<double>(power_by_exp2(HalfResult(c), k)); },
             [](double) { return 1.0; })
      .step;
}

// The first power that the evidence names is the first of all, power by power.
TEST(HalfBanding, BeginsWhereNoLowerPowerBands) {
  int first = 1;
  while (jump_at_half_cosine(first) <= 1) ++first;
  const auto evidence = evaluate(*find_claim("half-banding")).evidence;
  EXPECT_NE(evidence.find("half pow first bands at power " + std::to_string(first) + ":"), std::string::npos)
      << evidence;
}

// Why no power bands with a float cosine: with u = 2^-11 a step is at most twice the slope 112 v^(1/2.4) of
// the encoding times (2 u t + u), v = e^-t, which is largest at t + 1/2 = 2.4: 0.239 codes.
TEST(HalfBanding, RoundingsBoundEveryStepOfAFloatCosine) {
  for (const double k : {1.0, 3.0, 18.0, 100.0, 777.0, 1024.0, 2048.0}) {
    const HalfResult exponent = HalfResult::rounded(k), sharpness = base_two_power(exponent);
    const auto step = [&](const auto& curve) {
      return banding(floats_over_the_highlight(k, 1024), curve, [&](double c) { return power_lobe(c, k); })
          .step;
    };
    EXPECT_LT(step([&](double c) { return static_cast<double>(power_by_exp2(HalfResult(c), exponent)); }),
              0.239)
        << k;
    EXPECT_LT(step([&](double c) {
                return static_cast<double>(gaussian_lobe_base_two_of_difference(HalfResult(c), sharpness));
              }),
              0.239)
        << k;
  }
  const Claim& claim = *find_claim("half-banding");
  const std::string evidence = evaluate(claim).evidence;
  const std::string proof = "Rounding changes it by at most 0.24 codes at each power";
  for (const char* part : {"float pow never bands: ", "float exp2(A c - A) first bands at power 12: ",
                           "float exp2(A (c - 1)) never bands: ", proof.c_str()})
    EXPECT_NE(evidence.find(part), std::string::npos) << part << "\n" << evidence;
  // If that is not enough, every power is tried.
  const Claim fine =
      with_input(with_input(claim, "powers up to", "16"), "visible step in 8-bit sRGB codes", "0.2");
  EXPECT_EQ(evaluate(fine).evidence.find(proof), std::string::npos) << evaluate(fine).evidence;
}

// By hand: at A = 1477 halves are 1 apart, so A c - A is a whole number and the first step below the peak is
// from 1 to 1/2, whatever c is: 255 (1 - srgb(1/2)) = 67.48 codes. A half cosine's first step is exp(-1/2).
TEST(HalfBanding, OfPower1024IsThatOfWholeExponents) {
  const double half = srgb_code(1.0) - srgb_code(0.5);
  const HalfResult sharpness = base_two_power(HalfResult(1024));
  EXPECT_EQ(static_cast<double>(sharpness), 1477);
  const auto gaussian = [&](double c) {
    return static_cast<double>(gaussian_lobe_base_two(HalfResult(c), sharpness));
  };
  const Banding found = banding(halves_near_the_peak(), gaussian, [](double) { return 1.0; });
  EXPECT_NEAR(found.step, half, 1e-9);
  EXPECT_NEAR(jump_at_half_cosine(1024), srgb_code(1.0) - srgb_code(std::exp(-0.5)), 0.1);
}

// A multiply-add that rounds once, as newer processors have it, keeps what A c - A loses: it is A (c - 1).
TEST(HalfBanding, AFusedMultiplyAddIsTheDifferenceForm) {
  for (const double k : {16.0, 1024.0}) {
    const HalfResult sharpness = base_two_power(HalfResult(k));
    const auto a = static_cast<double>(sharpness);
    for (const double c : halves_near_the_peak()) {
      const HalfResult fused = exp2(HalfResult::rounded(std::fma(a, c, -a)));
      EXPECT_EQ(static_cast<double>(fused),
                static_cast<double>(gaussian_lobe_base_two_of_difference(HalfResult(c), sharpness)));
    }
  }
}

}  // namespace
}  // namespace shadefit
