#include "tests/fit/ledger/find_claim.hpp"
#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

/// A part of what a claim computes or tells, perhaps with a changed input.
struct Says {
  const char* claim;
  std::string_view part;
  const char* why;
  std::string_view input = {}, value = {};
};

TEST(Claims, SayWhatIsKnownOtherwise) {
  for (const auto& [claim, part, why, input, value] :
       {Says{"mip-gloss-chain", "2048 2048 2048 2048 2048 2", "the printed loop divides integers"},
        {"mip-mean-power", "power = 16386\n", "4/log(1 + 4/128^2)"},
        {"mip-mean-power", "printed digits are those of a lobe that has fallen to e^-2", "the same"},
        {"fresnel-quadratic-at-1", "ratio = 18.22554435\n", "exp((12.53789 - 8.35) ln 2), in 50 digits"},
        {"fresnel-quadratic-at-1", "cut off after the point it is 17", "0.003/0.000168 = 17.86"},
        {"fresnel-power-four", "at most 0.08192 (c = 0.2)",
         "c (1-c)^4 is largest where (1-c)^3 (1-5c) is 0: 256/3125"},
        {"fresnel-power-four", "rms 0.04495 (cosine)",
         "the integral of c^2 (1-c)^8 is B(3, 9) = 2! 8!/11! = 1/495"},
        {"sh-buffer-memory", "22118400 bytes", "24 bytes * 1280 * 720"},
        {"sh-linear-loss", "energy kept = 7/8 and 127/128\n", "3/8 + 1/2, and 15/128 more"},
        {"other-kernels",
         "is 0.6667 times that of the spherical Gaussian at k = 2048 and 0.6667 in the limit",
         "the limit of two thirds", "exponents", "3,2048"},
        {"norm-blinn-phong-brdf", "it creates no energy", "it is right at every view"},
        {"norm-blinn-phong-cheap", "1.075201161", "mpmath, 30 digits: findroot(diff(log ratio), 9)"},
        {"norm-blinn-phong-cheap", "at a = 8.76374", "the same"},
        {"phong-blinn-angle", "2 n.v: 1. ", "at 60 degrees both angles are equal across the plane", "views",
         "60"},
        {"phong-blinn-angle", "2 asin(1 - n.v): 60 degrees", "2 asin(1/2)", "views", "60"},
        {"pow-nan-at-zero", "0.00000001 (in half alone)", "what half rounds to 0 is 0 there", "exponents",
         "0, 1, 0.00000001"}}) {
    const Claim& said = *find_claim(claim);
    const Finding finding = evaluate(input.empty() ? said : with_input(said, input, value));
    const std::string text = finding.computed + "\n" + finding.evidence;
    EXPECT_NE(text.find(part), std::string::npos) << claim << ": " << part << ": " << why << "\n" << text;
  }
}

TEST(Claims, OverOneStepTheQuotientOfIntegersIsTheQuotient) {
  Claim claim = *find_claim("mip-gloss-chain");
  claim.printed = {{"", "2048"}, {"", "2"}};
  EXPECT_EQ(verdict_of(with_input(claim, "width", "8")), "confirmed");
  EXPECT_THROW(evaluate(with_input(claim, "width", "4")), std::invalid_argument);
}

TEST(Claims, AConstantThatIsTooLargeCreatesEnergy) {
  const Finding cheap = evaluate(with_printed(*find_claim("norm-blinn-phong-brdf"), 0, "(a+8)/(8 pi)"));
  EXPECT_EQ(cheap.verdict, Verdict::refuted);
  EXPECT_NE(cheap.evidence.find(": it creates energy"), std::string::npos) << cheap.evidence;
}

}  // namespace
}  // namespace shadefit
