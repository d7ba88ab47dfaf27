#include "approx/cost.hpp"
#include "approx/ledger/cost.hpp"

#include "approx/arithmetic.hpp"
#include "approx/environment_map.hpp"
#include "approx/gloss.hpp"
#include "approx/lobe.hpp"
#include "fit/ledger/lobes/shader_forms.hpp"
#include "fit/scalars/multiprecision.hpp"
#include "tests/fit/ledger/mutations.hpp"

namespace shadefit {
namespace {

TEST(CostClaims, RestOnWhatIsPrintedAndGiven) {
  check_mutations(cost_claims, {{"cost-pow", "printed 0", "4"},
                                {"cost-pow", "printed 1", "LOG2 MAD EXP2"},
                                {"cost-pow", "c^k", "gaussian"},
                                {"cost-sg", "printed 0", "3"},
                                {"cost-sg", "printed 1", "MUL EXP2"},
                                {"cost-sg", "printed 2", "2"},
                                {"cost-sg", "printed 3", "MAD MAD EXP2"},
                                {"cost-sg", "printed 4", "2"},
                                {"cost-sg", "printed 5", "MUL MAD EXP2"},
                                {"cost-sg", "A given", "gaussian-of-power"},
                                {"cost-sg", "A computed", "gaussian"},
                                {"cost-sg", "x added", "gaussian"},
                                {"cost-gloss-decode", "printed 0", "3"},
                                {"cost-gloss-decode", "printed 1", "ADD EXP2"},
                                {"cost-gloss-decode", "printed 2", "3"},
                                {"cost-gloss-decode", "printed 3", "MUL EXP2"},
                                {"cost-gloss-decode", "printed 4", "2"},
                                {"cost-gloss-decode", "printed 5", "MUL"},
                                {"cost-gloss-decode", "to a power", "pow"},
                                {"cost-gloss-decode", "to a sharpness", "gloss-decode"},
                                {"cost-gloss-decode", "normalisation", "normalisation"},
                                {"cost-saved", "printed 0", "2"},
                                {"cost-saved", "printed 1", "33"},
                                {"cost-saved", "with pow", "pow"},
                                {"cost-saved", "with the Gaussian", "gaussian"},
                                {"cost-saved", "Fresnel with pow", "fresnel-quadratic"},
                                {"cost-saved", "Fresnel with one term", "fresnel-quadratic"},
                                {"cost-saved", "whole Fresnel with pow", "schlick-pow"},
                                {"cost-saved", "whole Fresnel with one term", "fresnel-one-term"},
                                {"cost-power-four", "printed 0", "1"},
                                {"cost-power-four", "printed 1", "LOG2 LOG2"},
                                {"cost-power-four", "printed 2", "2"},
                                {"cost-power-four", "printed 3", "MUL MUL MUL"},
                                {"cost-power-four", "by exp2", "schlick-pow"},
                                {"cost-power-four", "by squaring", "schlick-squaring"},
                                {"cost-power-four", "by exp2, 1 - c given", "power-four-exp2"},
                                {"cost-power-four", "free scales of a result", "2 0.5"},
                                {"cost-phong-per-light", "printed 0", "3"},
                                {"cost-phong-per-light", "printed 1", "DOT3 EXP2"},
                                {"cost-phong-per-light", "per light", "phong-pow"},
                                {"cost-phong-per-light", "with pow", "phong-gaussian"},
                                {"cost-phong-per-light", "lights", "5"},
                                {"cost-fresnel", "printed 0", "3"},
                                {"cost-fresnel", "printed 1", "LOG2 MUL EXP2"},
                                {"cost-fresnel", "printed 2", "1"},
                                {"cost-fresnel", "printed 3", "MAD EXP2"},
                                {"cost-fresnel", "printed 4", "4"},
                                {"cost-fresnel", "printed 5", "MAD MAD EXP2"},
                                {"cost-fresnel", "printed 6", "3"},
                                {"cost-fresnel", "printed 7", "SUB MUL MUL"},
                                {"cost-fresnel", "pow", "schlick-squaring"},
                                {"cost-fresnel", "one term", "fresnel-quadratic"},
                                {"cost-fresnel", "quadratic", "fresnel-one-term"},
                                {"cost-fresnel", "by squaring", "power-four-squaring"},
                                {"cost-mip", "printed 0", "4"},
                                {"cost-mip", "printed 1", "LOG2 ADD"},
                                {"cost-mip", "level", "mip-level-of-successor"},
                                {"cost-mip", "level, s + 1 given", "mip-level"}});
}

TEST(CostClaims, AreConfirmedAsPrinted) {
  for (const char* id :
       {"cost-pow", "cost-sg", "cost-gloss-decode", "cost-saved", "cost-phong-per-light", "cost-fresnel"})
    EXPECT_EQ(verdict_of(*find_claim(id)), "confirmed") << id;
}

// With the addition printed too, the cost of the mip level is right; the source leaves it out.
TEST(CostClaims, TheMipLevelHasAnAdditionThatIsNotCounted) {
  const Claim& claim = *find_claim("cost-mip");
  EXPECT_EQ(verdict_of(claim), "other-objective");
  EXPECT_EQ(verdict_of(with_printed(with_printed(claim, 0, "3"), 1, "ADD LOG2 MAD")), "confirmed");
}

TEST(CostClaims, TheFourthPowerHasASubtractionThatIsNotCounted) {
  const Claim& claim = *find_claim("cost-power-four");
  EXPECT_EQ(verdict_of(claim), "other-objective");
  EXPECT_EQ(verdict_of(with_printed(with_printed(claim, 0, "4"), 1, "SUB LOG2 MUL EXP2")), "confirmed");
  EXPECT_EQ(verdict_of(with_printed(with_printed(claim, 0, "3"), 1, "SUB LOG2 EXP2")), "other-objective");
  EXPECT_EQ(verdict_of(with_input(claim, "free scales of a result", "2")), "refuted");
}

TEST(CostClaims, ARecordThatCannotBeReadIsRefused) {
  const Claim& claim = *find_claim("cost-pow");
  EXPECT_THROW(evaluate(with_input(claim, "c^k", "powf")), std::invalid_argument);
  EXPECT_THROW(evaluate(with_printed(claim, 1, "LOG2 MULL EXP2")), std::invalid_argument);
}

TEST(CostClaims, QuoteWhatCompilersEmitOfTheFormsThatAreCounted) {
  for (const CompiledCost& cost : compiled_costs) EXPECT_FALSE(shader_form(cost.form).empty()) << cost.form;
  const auto quotes = [](const Claim& claim) {
    return evaluate(claim).evidence.find("own measurement") != std::string::npos;
  };
  EXPECT_TRUE(quotes(*find_claim("cost-pow")));
  EXPECT_FALSE(quotes(*find_claim("cost-gloss-decode"))) << "none of its forms was compiled";
}

TEST(ShaderForms, ALightAddsAResult) {
  EXPECT_EQ(shader_form("phong-gaussian", 3).size(), 3u);
  EXPECT_EQ(shader_form("pow", 3).size(), 1u);
}

// Each formula that is counted is the one that it stands for, to 50 digits.
TEST(CostFormulas, AreWhatTheyStandFor) {
  using T = Decimal50;
  const auto is_close = [](const T& a, const T& b) { return abs(a - b) <= abs(b) * T("1e-42"); };
  for (const char* text : {"0", "0.3", "0.5", "1"}) {
    const T g(text), power = pow(T(2), T(10) * g + 1), sharpness = power / log(T(2));
    const auto value = [&](std::string_view form) {
      return evaluate<T>(shader_form(form).front(), [&](const std::string& name) {
        return name == "g"   ? g
               : name == "s" ? power
               : name == "A" ? sharpness
               : name == "c" ? T("0.9")
                             : T(0);
      });
    };
    EXPECT_TRUE(is_close(value("gloss-decode"), power)) << text;
    EXPECT_TRUE(is_close(value("gloss-decode-to-sharpness"), sharpness)) << text;
    EXPECT_TRUE(is_close(value("normalisation"), (power + 2) / 8)) << text;
    EXPECT_TRUE(is_close(value("normalisation-of-sharpness"), (power + 2) / 8)) << text;
    EXPECT_TRUE(is_close(value("specular-pow"), (power + 2) / 8 * pow(T("0.9"), power))) << text;
    EXPECT_TRUE(is_close(value("specular-gaussian"), (power + 2) / 8 * exp(power * T("-0.1")))) << text;
  }
  // A texel of the level spans the lobe: (w / 2^m)^2 = (s + 1)/3.
  const T level = mip_level_of_power(T(128), T(255));
  EXPECT_TRUE(is_close(T(128) * T(128) / pow(T(4), level), T(256) / 3));
  EXPECT_TRUE(is_close(mip_level_of_successor(T(128), T(256)), level));
  const std::array<T, 3> r{T("0.6"), T(0), T("0.8")}, l{T("0.36"), T("0.48"), T("0.8")};
  EXPECT_TRUE(is_close(phong_cosine(r, l), T("0.856")));
  EXPECT_TRUE(is_close(phong_by_exp2(scaled_reflection(r, base_two_power(T(10))), l),
                       gaussian_lobe(T("0.856"), T(10), T(0))));
}

}  // namespace
}  // namespace shadefit
