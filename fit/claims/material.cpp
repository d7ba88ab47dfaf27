#include <algorithm>

#include "approx/material.hpp"
#include "fit/ledger/topics.hpp"

namespace shadefit {
namespace {

/// Over every pair of codes, an sRGB-encoded base colour and a linear metallic.
struct Census {
  long above_one = 0;         ///< pairs whose albedo + F0, added up, is above 1
  long beyond_brightest = 0;  ///< pairs whose colour is above the closed form's brightest
  int first_colour = -1;      ///< the darkest colour code of these pairs; -1: none
};

Census census_of(double dielectric_f0, int codes) {
  // Sums of three numbers of size 1: a sum that exceeds 1 by a few roundings is 1.
  constexpr double one = 1 + 1e-12;
  Census census;
  for (int i = 0; i < codes; ++i) {
    const double colour = srgb_decode(i / (codes - 1.0));
    for (int j = 0; j < codes; ++j) {
      const double metallic = j / (codes - 1.0);
      const double sum = metallic_albedo(colour, metallic) + metallic_f0(dielectric_f0, colour, metallic);
      if (sum > one) {
        ++census.above_one;
        if (census.first_colour < 0) census.first_colour = i;
      }
      if (colour > brightest_base_colour(dielectric_f0, metallic) * one) ++census.beyond_brightest;
    }
  }
  return census;
}

/// The effect on a dielectric of clamping the base colour to the brightest with a sum of at most 1.
std::string effect_of_clamp(double dielectric_f0, int codes) {
  const double brightest = std::max(0.0, brightest_base_colour(dielectric_f0, 0.0));
  Effect effect;
  for (int i = 0; i < codes; ++i) {
    const double colour = srgb_decode(i / (codes - 1.0));
    effect.show(colour, std::min(colour, brightest), {{"code ", static_cast<double>(i)}, {"m = ", 0}});
  }
  return sentence(
      effect, "it",
      fmt::format("a clamp of the base colour to {:.4g}, which reflects no more light than arrives,",
                  brightest));
}

Finding metallic_workflow(const Claim& claim) {
  const double f0 = number_of(claim.printed[0].value);
  const int codes = static_cast<int>(given(claim, "codes"));
  const Census census = census_of(f0, codes);
  const double brightest = brightest_base_colour(f0, 0.0);
  const Verdict verdict = verdict_of(f0 <= 0, f0 <= 1);
  return told(claim, census.above_one == census.beyond_brightest ? std::optional(verdict) : std::nullopt,
              effect_of_clamp(f0, codes), Told{"brightest", brightest},
              Told{"brightest_code", srgb_code(brightest)}, Told{"above_one", census.above_one},
              Told{"first_colour", census.first_colour});
}

}  // namespace

std::vector<Evaluator> material_evaluators() {
  return {{"metallic-workflow", metallic_workflow}};
}

}  // namespace shadefit
