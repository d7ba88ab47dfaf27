#include "approx/normalisation.hpp"

#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

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
}

// (a+8)/(8 pi) over (a+2)(a+4)/(8 pi (2^(-a/2) + a)): the largest ratio and its place by mpmath, 30 digits:
// findroot(diff(log ratio), 9).
TEST(NormalisationClaims, TheCheapConstantIsFurthestWhereMpmathSays) {
  const Finding cheap = evaluate(claim_of("norm-blinn-phong-cheap"));
  EXPECT_EQ(cheap.verdict, Verdict::conditional);
  EXPECT_NE(cheap.computed.find("1.075201161"), std::string::npos) << cheap.computed;
  EXPECT_NE(cheap.evidence.find("at a = 8.76374"), std::string::npos) << cheap.evidence;
}

}  // namespace
}  // namespace shadefit
