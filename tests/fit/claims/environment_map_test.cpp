#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

TEST(EnvironmentMapClaims, ThePrintedLoopDividesIntegers) {
  Claim claim = *find_claim("mip-gloss-chain");
  EXPECT_NE(evaluate(claim).evidence.find("2048 2048 2048 2048 2048 2"), std::string::npos);
  // Over one step the quotient of integers is the quotient.
  claim.printed = {{"", "2048"}, {"", "2"}};
  EXPECT_EQ(verdict_of(with_input(claim, "width", "8")), "confirmed");
  EXPECT_THROW(evaluate(with_input(claim, "width", "4")), std::invalid_argument);
}

TEST(EnvironmentMapClaims, ThePowerOfThePrintedDigits) {
  const Claim& claim = *find_claim("mip-mean-power");
  EXPECT_EQ(evaluate(claim).computed, "power = 16386");  // 4/log(1 + 4/128^2)
  EXPECT_NE(evaluate(claim).evidence.find("printed digits are those of a lobe that has fallen to e^-2"),
            std::string::npos);
}

}  // namespace
}  // namespace shadefit
