#include "approx/normalisation.hpp"
#include "approx/ledger/normalisation.hpp"

#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

TEST(NormalisationClaims, RestOnWhatIsPrintedAndGiven) {
  check_mutations(normalisation_claims,
                  {{"norm-lambert", "printed 0", "1/(2 pi)"},
                   {"norm-lambert", "printed 0", "1/3.14159265"},
                   {"norm-phong", "printed 0", "(a+2)/(2 pi)"},
                   {"norm-phong", "printed 0", "(a+1)/(2 * 3.1415926535)"},
                   {"norm-phong", "exponents", "0.5,3"},
                   {"norm-phong", "exponents at other views", "2"},
                   {"norm-phong", "view angles", "10,80"},
                   {"norm-phong-brdf", "printed 0", "(a+1)/(2 pi)"},
                   {"norm-phong-brdf", "printed 0", "(a+2)/(4 pi)"},
                   {"norm-phong-brdf", "exponents", "0.5,3"},
                   {"norm-phong-brdf", "exponents at other views", "2"},
                   {"norm-phong-brdf", "view angles", "10,80"},
                   {"norm-blinn-phong", "printed 0", "(a+2)/(4 pi (2 - 2^(-a)))"},
                   {"norm-blinn-phong", "printed 0", "(a+2)/(8 pi)"},
                   {"norm-blinn-phong", "exponents", "0.5,3"},
                   {"norm-blinn-phong", "exponents at other views", "2"},
                   {"norm-blinn-phong", "view angles", "10,80"},
                   {"norm-blinn-phong-brdf", "printed 0", "(a+2)(a+4)/(8 pi (2^(-a) + a))"},
                   {"norm-blinn-phong-brdf", "printed 0", "(a+8)/(8 pi)"},
                   {"norm-blinn-phong-brdf", "exponents", "0.5,3"},
                   {"norm-blinn-phong-brdf", "exponents at other views", "2"},
                   {"norm-blinn-phong-brdf", "view angles", "10,80"},
                   {"norm-blinn-phong-cheap", "printed 0", "(a+9)/(8 pi)"},
                   {"norm-blinn-phong-cheap", "printed 0", "(a+2)(a+4)/(8 pi (2^(-a/2) + a))"},
                   {"norm-blinn-phong-cheap", "close", "0.0752"},
                   {"norm-blinn-phong-cheap", "low power", "2"},
                   {"norm-blinn-phong-cheap", "exponents", "0.5,3"},
                   {"norm-blinn-phong-cheap", "exponents at other views", "2"},
                   {"norm-blinn-phong-cheap", "view angles", "1,80"},
                   {"norm-ndf", "printed 0", "(a+1)/(2 pi)"},
                   {"norm-ndf", "exponents", "0.5,3"},
                   {"norm-microfacet", "printed 0", "(a+2)/(4 pi)"},
                   {"norm-microfacet", "printed 1", "(a+2)/4"},
                   {"norm-microfacet", "printed 1", "(a+8)/8"},
                   {"norm-microfacet", "exponents", "0.5,3"},
                   {"norm-microfacet", "light unit", "1"},
                   {"norm-game-light-unit", "with pi", "pi c_diff/3.14"},
                   {"norm-game-light-unit", "without", "c_diff/pi"}});
}

Claim claim_of(std::string_view id) {
  return *find_claim(id);
}

// A constant above the exact one creates energy along the normal and is wrong there. A constant that is right
// there is tested at other views.
TEST(NormalisationClaims, AConstantThatIsTooLargeCreatesEnergy) {
  const Finding right = evaluate(claim_of("norm-blinn-phong-brdf"));
  EXPECT_EQ(right.verdict, Verdict::confirmed);
  EXPECT_NE(right.evidence.find("it creates no energy"), std::string::npos);
  const Finding cheap = evaluate(with_printed(claim_of("norm-blinn-phong-brdf"), 0, "(a+8)/(8 pi)"));
  EXPECT_EQ(cheap.verdict, Verdict::refuted);
  EXPECT_NE(cheap.evidence.find(": it creates energy"), std::string::npos) << cheap.evidence;
  EXPECT_NE(cheap.effect, "none");
}

// (a+8)/(8 pi) over (a+2)(a+4)/(8 pi (2^(-a/2) + a)): the largest ratio and its place by mpmath, 30 digits:
// findroot(diff(log ratio), 9).
TEST(NormalisationClaims, TheCheapConstantIsFurthestWhereMpmathSays) {
  const Finding cheap = evaluate(claim_of("norm-blinn-phong-cheap"));
  EXPECT_EQ(cheap.verdict, Verdict::conditional);
  EXPECT_NE(cheap.computed.find("1.075201161"), std::string::npos) << cheap.computed;
  EXPECT_NE(cheap.evidence.find("at a = 8.76374"), std::string::npos) << cheap.evidence;
  const auto with_close = [&](const char* close) {
    return verdict_of(with_input(claim_of("norm-blinn-phong-cheap"), "close", close));
  };
  EXPECT_EQ(with_close("0.0753"), "conditional");
  EXPECT_EQ(with_close("0.0752"), "refuted");
}

// The exact constant instead of the stand-in: the difference is 0 for every power.
TEST(NormalisationClaims, AStandInIsJudgedAtLowPowersToo) {
  const auto verdict = [&](const char* printed) {
    return verdict_of(with_printed(claim_of("norm-blinn-phong-cheap"), 0, printed));
  };
  EXPECT_EQ(verdict("1.01 (a+2)(a+4)/(8 pi (2^(-a/2) + a))"), "refuted") << "as far at every power";
  // the exact one times 1 + a/1e8: the lower the closer, all the way
  EXPECT_EQ(verdict("((a+2)(a+4)/(8 pi (2^(-a/2) + a))) (1 + a/100000000)"), "confirmed");
}

TEST(NormalisationClaims, AFormulaThatCannotBeReadIsAnError) {
  EXPECT_THROW(evaluate(with_printed(claim_of("norm-ndf"), 0, "(a+2)/2 pi")), std::invalid_argument);
  EXPECT_THROW(evaluate(with_printed(claim_of("norm-ndf"), 0, "(b+2)/(2 pi)")), std::invalid_argument);
  EXPECT_THROW(evaluate(with_printed(claim_of("norm-ndf"), 0, "a/(a - a)")), std::domain_error);
}

}  // namespace
}  // namespace shadefit
