#include <gtest/gtest.h>

#include "fit/formula/parse_formula.hpp"
#include "fit/ledger/ledger.hpp"
#include "fit/scalars/in_50_digits.hpp"
#include "tests/fit/ledger/find_claim.hpp"

namespace shadefit {
namespace {

// Each formula that is counted is the one that it stands for, to 50 digits.
TEST(CostFormulas, AreWhatTheyStandFor) {
  using T = Decimal50;
  const T g("0.3"), s = pow(T(2), 10 * g + 1), c("0.9"), f0("0.04"), ln_2 = log(T(2)),
                    fifth = pow(1 - c, T(5));
  const std::map<std::string, T> values{
      {"g", g},         {"s", s},          {"A", s / ln_2},   {"c", c},
      {"k", s},         {"y", 1 - c},      {"F0", f0},        {"s1", s + 1},
      {"a", T(-2)},     {"b", T(-3)},      {"rx", T("0.6")},  {"ry", T(0)},
      {"rz", T("0.8")}, {"l0x", T("0.5")}, {"l0y", T("0.3")}, {"l0z", T("0.75")}};
  const T phong("0.9"), gaussian = exp(s * (c - 1)), power = pow(c, s), normalisation = (s + 2) / 8,
                        sharpness = s / ln_2;
  const T level = log(T(128) * sqrt(T(3)) / sqrt(s + 1)) / ln_2;
  struct Case {
    const char* claim;
    const char* input;
    T truth;
  };
  for (const auto& [claim, input, truth] : {Case{"cost-pow", "c^k", power},
                                            {"cost-sg", "A given", gaussian},
                                            {"cost-sg", "A computed", gaussian},
                                            {"cost-sg", "x added", exp((s + T("0.775")) * (c - 1))},
                                            {"cost-gloss-decode", "to a power", s},
                                            {"cost-gloss-decode", "to a sharpness", sharpness},
                                            {"cost-gloss-decode", "normalisation", normalisation},
                                            {"cost-saved", "with pow", normalisation * power},
                                            {"cost-saved", "with the Gaussian", normalisation * gaussian},
                                            {"cost-saved", "Fresnel with pow", fifth},
                                            {"cost-saved", "whole Fresnel with pow", f0 + (1 - f0) * fifth},
                                            {"cost-saved", "Fresnel with one term", exp(-s * c)},
                                            {"cost-power-four", "by exp2", fifth / (1 - c)},
                                            {"cost-power-four", "by squaring", fifth / (1 - c)},
                                            {"cost-power-four", "by exp2, 1 - c given", fifth / (1 - c)},
                                            {"cost-phong-per-light", "per light", exp(s * (phong - 1))},
                                            {"cost-phong-per-light", "with pow", pow(phong, s)},
                                            {"cost-fresnel", "pow", fifth},
                                            {"cost-fresnel", "quadratic", exp((-2 * c - 3) * c * ln_2)},
                                            {"cost-fresnel", "by squaring", fifth},
                                            {"cost-mip", "level", level},
                                            {"cost-mip", "level, s + 1 given", level}}) {
    const std::string_view text = find_claim(claim)->inputs.at(input);
    const T value = in_50_digits(read_formula(text, {.variables = {}, .takes_parameters = true}).formula,
                                 [&](const std::string& name) { return values.at(name); });
    EXPECT_LE(abs(value / truth - 1), T("1e-42")) << text;
  }
}

}  // namespace
}  // namespace shadefit
