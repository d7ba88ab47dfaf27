#include "approx/fresnel.hpp"
#include "approx/ledger/fresnel.hpp"

#include "fit/ledger/where.hpp"
#include "fit/scalars/multiprecision.hpp"
#include "tests/accuracy.hpp"
#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

TEST(FresnelClaims, RestOnWhatIsPrintedAndGiven) {
  check_mutations(fresnel_claims, {{"fresnel-one-term", "printed 0", "8.37"},
                                   {"fresnel-one-term", "x", "0.8"},
                                   {"fresnel-one-term", "from", "0.1"},
                                   {"fresnel-one-term", "to", "0.9"},
                                   {"fresnel-one-term-at-1", "printed 0", "0.004"},
                                   {"fresnel-one-term-at-1", "A", "8.3"},
                                   {"fresnel-one-term-at-1", "f0", "0.05"},
                                   {"fresnel-quadratic", "printed 0", "-5.55437"},
                                   {"fresnel-quadratic", "printed 1", "-6.983146"},
                                   {"fresnel-quadratic", "from", "0.1"},
                                   {"fresnel-quadratic", "to", "0.9"},
                                   {"fresnel-quadratic-at-1", "printed 0", "0.000178"},
                                   {"fresnel-quadratic-at-1", "printed 1", "18"},
                                   {"fresnel-quadratic-at-1", "printed 1", "16"},
                                   {"fresnel-quadratic-at-1", "a", "-5.6"},
                                   {"fresnel-quadratic-at-1", "b", "-7"},
                                   {"fresnel-quadratic-at-1", "A", "8.656170"},
                                   {"fresnel-quadratic-at-1", "exp2(-A) as printed", "0.0031"},
                                   {"fresnel-quadratic-at-1", "f0", "0.05"},
                                   {"fresnel-offset-one", "printed 0", "8.656180"},
                                   {"fresnel-offset-one", "from", "0.1"},
                                   {"fresnel-offset-one", "to", "0.9"},
                                   {"fresnel-power-four", "power", "5"},
                                   {"fresnel-power-four", "A", "8.656170"},
                                   {"fresnel-power-four", "f0", "0.05"},
                                   {"fresnel-relative-error", "a", "-5.6"},
                                   {"fresnel-relative-error", "b", "-7"},
                                   {"fresnel-relative-error", "A", "8.35"},
                                   {"fresnel-relative-error", "f0", "0.05"},
                                   {"fresnel-relative-error", "far smaller", "0.2"},
                                   {"fresnel-exponent-sum", "printed 0", "-12.53780"},
                                   {"fresnel-exponent-sum", "a", "-5.55437"},
                                   {"fresnel-exponent-sum", "b", "-6.983146"},
                                   {"fresnel-roughness", "from", "-0.1"},
                                   {"fresnel-roughness", "to", "2.5"},
                                   {"fresnel-roughness", "steps", "15"}});
}

TEST(FresnelClaims, EveryDigitMatters) {
  for (const char* id :
       {"fresnel-one-term", "fresnel-one-term-at-1", "fresnel-quadratic", "fresnel-exponent-sum"})
    check_every_digit(*find_claim(id));
}

// The other side of each comparison.
TEST(FresnelClaims, ComparisonsCanTurnOut) {
  const Claim& four = *find_claim("fresnel-power-four");
  EXPECT_EQ(verdict_of(four), "confirmed");
  EXPECT_EQ(verdict_of(with_input(four, "power", "5")), "refuted") << "(1-c)^5 itself is no worse";
  EXPECT_EQ(verdict_of(with_input(four, "A", "1")), "refuted") << "nor is anything worse than exp2(-c)";
  // Blunter or sharper than the best: different meanings give different answers.
  EXPECT_EQ(verdict_of(with_input(four, "A", "7.2")), "conditional");
  EXPECT_EQ(verdict_of(with_input(four, "A", "11")), "other-objective");

  const Claim& relative = *find_claim("fresnel-relative-error");
  EXPECT_EQ(verdict_of(relative), "confirmed");
  EXPECT_EQ(verdict_of(with_input(relative, "far smaller", "0.2")), "refuted");
  EXPECT_EQ(verdict_of(with_input(relative, "a", "0")), "refuted");

  const Claim& roughness = *find_claim("fresnel-roughness");
  EXPECT_EQ(verdict_of(roughness), "confirmed");
  EXPECT_EQ(verdict_of(with_input(roughness, "from", "-0.001")), "refuted") << "without its saturate";
  EXPECT_EQ(verdict_of(with_input(roughness, "to", "1.5")), "refuted");
}

TEST(FresnelClaims, SeventeenIsTheQuotientOfThePrintedValuesCutOff) {
  const Finding finding = evaluate(*find_claim("fresnel-quadratic-at-1"));
  EXPECT_EQ(finding.verdict, Verdict::rounding);
  // exp2(-8.35 + 12.53789) = exp(4.18789 ln 2), in 50 digits
  const Decimal50 ratio = exp(Decimal50("4.18789") * ln2<Decimal50>());
  EXPECT_NE(finding.computed.find("ratio = " + decimal(static_cast<double>(ratio), 10)), std::string::npos)
      << finding.computed;
  EXPECT_EQ(static_cast<int>(0.003 / 0.000168), 17);
  EXPECT_NE(finding.evidence.find("cut off after the point it is 17"), std::string::npos) << finding.evidence;
}

// c (1-c)^4 is largest where its derivative (1-c)^3 (1-5c) is 0.
TEST(FresnelClaims, PowerFourIsFurthestAtOneFifth) {
  const Finding finding = evaluate(*find_claim("fresnel-power-four"));
  EXPECT_NE(finding.evidence.find("at most " + decimal(256.0 / 3125, 4) + " (c = 0.2)"), std::string::npos)
      << finding.evidence;
  // integral of c^2 (1-c)^8 = B(3, 9) = 2! 8!/11! = 1/495
  EXPECT_NE(finding.evidence.find("rms " + decimal(std::sqrt(1.0 / 495), 4) + " (cosine)"), std::string::npos)
      << finding.evidence;
}

TEST(Fresnel, ReflectanceOfGlossIsAMeanOfItsEnds) {
  for (const char* f0 : {"0", "0.04", "0.5", "1"}) {
    for (const char* gloss : {"0", "0.04", "0.7", "1"}) {
      for (const char* weight : {"0", "0.25", "1"}) {
        const Decimal50 f(f0), g(gloss), w(weight), top = f < g ? g : f;
        EXPECT_TRUE(testing::is_close(std::string(f0) + " " + gloss + " " + weight, f * (1 - w) + top * w,
                                      schlick_reflectance_of_gloss(f, g, w), 1e-48));
      }
    }
  }
}

TEST(Fresnel, TheExponentAtNormalIncidenceIsTheSum) {
  const Decimal50 a("-5.55473"), b("-6.98316"), one(1);
  EXPECT_EQ(decimal(static_cast<double>(fresnel_quadratic_exponent(one, a, b)), 10), "-12.53789");
  EXPECT_TRUE(testing::is_close("c = 1", Decimal50(pow(Decimal50(2), Decimal50("-12.53789"))),
                                fresnel_quadratic(one, a, b), 1e-48));
}

TEST(Where, APartIsACondition) {
  EXPECT_EQ(verdict_of_cases(3, 3), Verdict::confirmed);
  EXPECT_EQ(verdict_of_cases(1, 3), Verdict::conditional);
  EXPECT_EQ(verdict_of_cases(0, 3), Verdict::refuted);
}

TEST(Where, FindsTheRangesAndTheirEnds) {
  const auto inside = where_negative([](double s) { return (s - 0.25) * (s - 0.5); });
  ASSERT_EQ(inside.size(), 1U);
  EXPECT_NEAR(inside[0].first, 0.25, 1e-15);
  EXPECT_NEAR(inside[0].second, 0.5, 1e-15);
  const auto outside = where_negative([](double s) { return (s - 0.25) * (0.5 - s); });
  ASSERT_EQ(outside.size(), 2U);
  EXPECT_EQ(outside[0].first, 0);
  EXPECT_NEAR(outside[0].second, 0.25, 1e-15);
  EXPECT_NEAR(outside[1].first, 0.5, 1e-15);
  EXPECT_EQ(outside[1].second, 1);
  EXPECT_EQ(ranges_in_words(outside, 3), "from c = 0 to 0.25 and from c = 0.5 to 1");
  EXPECT_EQ(ranges_in_words(where_negative([](double) { return 0.0; }), 3), "nowhere");
}

}  // namespace
}  // namespace shadefit
