#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "approx/fresnel.hpp"
#include "approx/material.hpp"
#include "fit/claims/diffuse_fresnel.hpp"
#include "fit/ledger/topics.hpp"

namespace shadefit {
namespace {

/// The relative tolerance of quadrature: sums of a few parts of size 1 are then accurate to 1e-12.
constexpr double mean_tolerance = 1e-14;
constexpr double mean_rounding = 1e-12;

/// The mean over the hemisphere of f(F), with Schlick's F at each direction, weighted by the cosine: the
/// integral of f 2c dc by Gauss-Kronrod, the difference to tanh-sinh as its error.
template <class F>
Integral hemisphere_mean(const F& f, double f0) {
  const auto integrand = [&](double c) { return f(schlick_reflectance(f0, schlick_weight(c))) * 2 * c; };
  const Integral first = gauss_kronrod(integrand, 0, 1, mean_tolerance);
  const Integral second = tanh_sinh(integrand, 0, 1, mean_tolerance);
  return {first.value, std::abs(first.value - second.value)};
}

/// The smallest cosine c0 for which the sum is at most 1 on [c0, 1]. It returns 2 if no c0 exists. The sum
/// is linear in F of the one fixed direction, F = f0 (normal) .. 1 (grazing), so it is 1 at one weight w of
/// Schlick's formula between normal (w = 0) and grazing (w = 1), and c = 1 - w^(1/5).
double from_cosine(double at_normal, double at_grazing) {
  if (at_normal > 1 + mean_rounding) return 2;
  if (at_grazing <= 1 + mean_rounding) return 0;
  const double weight = (1 - at_normal) / (at_grazing - at_normal);
  return 1 - (weight < mean_rounding ? 0 : std::pow(weight, 0.2));
}

/// `factor_of(F_fixed, F_other)`.
template <class Factor>
DiffuseUnderFresnel sum_of(const Factor& factor_of, double albedo, double f0) {
  double error = 0;
  const auto sum = [&](double fixed) {
    const Integral mean = hemisphere_mean([&](double other) { return factor_of(fixed, other); }, f0);
    error = std::max(error, mean.error);
    return fixed + albedo * mean.value;
  };
  const double at_normal = sum(f0), at_grazing = sum(1);
  const Integral sky = hemisphere_mean(sum, f0);
  return {at_normal, at_grazing, sky.value, std::max(error, sky.error), from_cosine(at_normal, at_grazing)};
}

template <class Factor>
DiffuseUnderFresnel both_ways(double albedo, double f0) {
  const auto from_light =
      sum_of([&](double in, double out) { return Factor::factor(in, out, f0); }, albedo, f0);
  const auto towards_view =
      sum_of([&](double out, double in) { return Factor::factor(in, out, f0); }, albedo, f0);
  return {std::max(from_light.at_normal, towards_view.at_normal),
          std::max(from_light.at_grazing, towards_view.at_grazing),
          from_light.under_sky,  // the same light, summed in another order
          std::max(from_light.error, towards_view.error),
          std::max(from_light.from_cosine, towards_view.from_cosine)};
}

std::string where_it_holds(const DiffuseUnderFresnel& found) {
  if (found.from_cosine > 1) return "above 1 at every angle";
  if (found.from_cosine == 0) return "at most 1 at every angle";
  if (found.from_cosine == 1) return "at most 1 only at normal incidence";
  return fmt::format("at most 1 for cosines above {:.4g}", found.from_cosine);
}

std::string part_sentence(std::string_view factor, const DiffuseUnderFresnel& found) {
  return fmt::format(
      "with {} the sum is {:.6g} at normal and {:.6g} at grazing incidence, {}, and {:.6g} under a uniform "
      "sky",
      factor, found.at_normal, found.at_grazing, where_it_holds(found), found.under_sky);
}

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

DiffuseUnderFresnel diffuse_under_fresnel(std::string_view factor, double albedo, double f0) {
  const auto is = [&]<class Factor>(Factor) { return factor == Factor::name; };
  if (is(TransmittedBothWays{})) return both_ways<TransmittedBothWays>(albedo, f0);
  if (is(TransmittedIn{})) return both_ways<TransmittedIn>(albedo, f0);
  if (is(TransmittedAtNormal{})) return both_ways<TransmittedAtNormal>(albedo, f0);
  if (is(Unattenuated{})) return both_ways<Unattenuated>(albedo, f0);
  throw std::invalid_argument(fmt::format("not a factor of the diffuse term: '{}'", factor));
}

namespace {

/// The claim of two factors, "factor" and "stand-in", at an "albedo" and an "f0"; "beside" is a third.
Finding diffuse_fresnel(const Claim& claim) {
  const double albedo = given(claim, "albedo"), f0 = given(claim, "f0");
  const auto under = [&](std::string_view name) {
    return diffuse_under_fresnel(claim.inputs.at(name), albedo, f0);
  };
  const auto factor = under("factor"), stand_in = under("stand-in"), beside = under("beside");
  const auto judged = [](const DiffuseUnderFresnel& found) {
    return verdict_of(found.from_cosine == 0, found.from_cosine <= 1);
  };
  const std::array verdicts{judged(factor), judged(stand_in)};
  const bool is_known = std::max({factor.error, stand_in.error, beside.error}) <= mean_rounding;
  const auto share = [](const DiffuseUnderFresnel& found) {
    return std::max(found.at_normal, found.at_grazing);
  };
  return told(claim, is_known ? std::optional(worst(verdicts)) : std::nullopt,
              effect_of_factor(stand_in.under_sky, factor.under_sky,
                               fmt::format("under a uniform sky {} instead of {}",
                                           claim.inputs.at("stand-in"), claim.inputs.at("factor"))),
              Told{"share", share(factor)}, Told{"stand_in_share", share(stand_in)},
              Told{"as_stated", part_sentence(claim.inputs.at("factor"), factor)},
              Told{"stand_in_sum", part_sentence(claim.inputs.at("stand-in"), stand_in)},
              Told{"beside_sum", part_sentence(claim.inputs.at("beside"), beside)},
              Told{"rounding", mean_rounding});
}

}  // namespace

std::vector<Evaluator> material_evaluators() {
  return {{"metallic-workflow", metallic_workflow}, {"diffuse-fresnel", diffuse_fresnel}};
}

}  // namespace shadefit
