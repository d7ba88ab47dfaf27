#include "approx/material.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "approx/encoding.hpp"
#include "fit/errors/effect.hpp"
#include "fit/ledger/surfaces/diffuse_fresnel.hpp"
#include "fit/ledger/topics.hpp"
#include "fit/support/format.hpp"

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
  const double brightest = brightest_base_colour(f0, 0.0), most = 1 + f0;
  const std::string text(claim.printed[0].value);
  const Verdict verdict = f0 <= 0 ? Verdict::confirmed : f0 > 1 ? Verdict::refuted : Verdict::conditional;
  const long pairs = static_cast<long>(codes) * codes;
  return {
      census.above_one == census.beyond_brightest ? std::optional(verdict) : std::nullopt,
      fmt::format("only for c <= 1 - {} (1-m)", text),
      fmt::format(
          "albedo + F0 = c + {} (1-m) is at most 1 exactly where c <= 1 - {} (1-m). Up to c = {:.4g} (code "
          "{:.4g}) that is true at every m. For a larger c it is true only for m >= 1 - (1-c)/{}. The "
          "largest sum is "
          "{:.4g} at c = 1, m = 0: a white dielectric at normal incidence. Among the {} pairs of codes (c, "
          "m) {} have "
          "a sum above 1{}, as many as the closed form says",
          text, text, brightest, srgb_code(brightest), text, most, pairs, census.above_one,
          census.above_one > 0 ? fmt::format(", from colour code {} on", census.first_colour) : ""),
      effect_of_clamp(f0, codes)};
}

struct Channels {
  int sum = 0;
  std::string sentence;  ///< "albedo 3, specular 3, roughness 1"
};

/// From a list of maps, each with its number of channels after its name.
Channels channels_of(std::string_view maps) {
  Channels channels{0, std::string(maps)};
  for (const std::string_view map : items_of(maps))
    channels.sum += static_cast<int>(number_of(map.substr(map.rfind(' ') + 1)));
  return channels;
}

Finding workflow_channels(const Claim& claim) {
  const Channels specular = channels_of(claim.inputs.at("specular maps"));
  const Channels metallic = channels_of(claim.inputs.at("metallic maps"));
  const Channels more = channels_of(claim.inputs.at("one more map"));
  const auto judged = [](const Quantity& printed, const Channels& channels) {
    // A count is right or wrong: there is nothing to round.
    return verdict_of(number_of(printed.value) == channels.sum);
  };
  const std::array verdicts{judged(claim.printed[0], specular), judged(claim.printed[1], metallic)};
  return {
      worst(verdicts), fmt::format("specular = {}, metallic = {}", specular.sum, metallic.sum),
      fmt::format(
          "specular workflow: {}, in all {} channels. Metallic workflow: {}, in all {}, {} fewer; {} with "
          "one more map, {}",
          specular.sentence, specular.sum, metallic.sentence, metallic.sum, specular.sum - metallic.sum,
          metallic.sum + more.sum, more.sentence),
      "none"};
}

}  // namespace

std::vector<Evaluator> material_evaluators() {
  return {{"metallic-workflow", metallic_workflow},
          {"workflow-channels", workflow_channels},
          {"diffuse-fresnel", diffuse_fresnel}};
}

}  // namespace shadefit
