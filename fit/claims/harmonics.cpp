#include "approx/harmonics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fit/ledger/topics.hpp"

namespace shadefit {
namespace {

constexpr double harmonic_tolerance = 1e-14;

/// The part of the clamped cosine in its first bands.
struct Kept {
  double energy = 0;          ///< share of the squared norm
  double peak = 0;            ///< value towards the light, where the original is 1
  std::vector<double> peaks;  ///< that of each band

  /// Bands 0 .. bands - 1, from moments by two rules beside their closed form.
  Kept(int bands, Agreement& agreement) {
    for (int band = 0; band < bands; ++band) {
      const double moment = clamped_cosine_moment<double>(band);
      const auto integrand = [band](double c) { return c * legendre_polynomial(band, c); };
      // An odd moment beyond the first is 0, so moments plus 1 are compared.
      const Integral found = gauss_kronrod(integrand, 0, 1, harmonic_tolerance, harmonic_tolerance);
      agreement.compare(moment + 1, {found.value + 1, found.error},
                        tanh_sinh([&](double c) { return integrand(c) + 1; }, 0, 1, harmonic_tolerance));
      energy += energy_of_band(band, moment);
      peaks.push_back(peak_of_band(band, moment));
      peak += peaks.back();
    }
  }
};

/// The effect of keeping only those bands on a white surface, at every degree from the light.
std::string effect_of_keeping(const Kept& kept, std::string_view coefficients) {
  Effect effect;
  for (int degrees = 0; degrees <= 180; ++degrees) {
    const double cosine = std::cos(degrees * std::numbers::pi / 180);
    double sum = 0;
    for (std::size_t band = 0; band < kept.peaks.size(); ++band)
      sum += kept.peaks[band] * legendre_polynomial(static_cast<int>(band), cosine);
    effect.show(std::max(0.0, cosine), sum, {{"theta = ", static_cast<double>(degrees), " degrees"}});
  }
  return sentence(effect, "the light on a white surface",
                  fmt::format("keeping {} coefficients", coefficients));
}

/// A number as the fraction with the smallest denominator up to 4096 that equals it to 1e-12; else as a
/// decimal.
std::string as_fraction(double value) {
  for (int denominator = 1; denominator <= 4096; ++denominator) {
    const double numerator = std::round(value * denominator);
    if (std::abs(numerator / denominator - value) <= 1e-12)
      return fmt::format("{:.6g}{}", numerator, denominator == 1 ? "" : fmt::format("/{}", denominator));
  }
  return decimal(value, 6);
}

/// The number of bands from which on the value towards the light is within one 8-bit sRGB code of the
/// original, looked at up to `most` bands.
int bands_within_a_code(int most) {
  int enough = 1;
  double peak = 0;
  for (int band = 0; band < most; ++band) {
    peak += peak_of_band(band, clamped_cosine_moment<double>(band));
    // above 1 the code is clamped but the light is not: an excess counts like the same deficit
    if (srgb_code(1.0) - srgb_code(1 - std::abs(peak - 1)) > 1) enough = band + 2;
  }
  return enough;
}

Finding evaluate_loss(const Claim& claim) {
  const std::string_view tolerance = claim.inputs.at("tolerance");
  Agreement agreement;
  const auto keep = [&](std::string_view coefficients) {
    return Kept(static_cast<int>(std::lround(std::sqrt(given(claim, coefficients)))), agreement);
  };
  const Kept few = keep("coefficients"), more = keep("more coefficients");
  const double little = given(claim, "a little");
  const bool is_little = few.energy < 1 && 1 - few.energy <= little;
  const bool is_closer = more.energy > few.energy && std::abs(more.peak - 1) < std::abs(few.peak - 1);
  const std::optional<Verdict> parts[] = {agreement.verdict(number_of(tolerance)), verdict_of(is_little),
                                          verdict_of(is_closer)};
  const int enough = bands_within_a_code(64);
  return told(claim, worst(parts),
              sentences({effect_of_keeping(few, claim.inputs.at("coefficients")),
                         effect_of_keeping(more, claim.inputs.at("more coefficients"))}),
              Told{"few", few.energy}, Told{"few_share", as_fraction(few.energy)},
              Told{"few_peak", as_fraction(few.peak)}, Told{"more", more.energy},
              Told{"more_share", as_fraction(more.energy)}, Told{"more_peak", as_fraction(more.peak)},
              Told{"agree", within(agreement.gap, tolerance)}, Told{"enough", enough * enough},
              Told{"dark", srgb_code(1.0) - srgb_code(few.peak)}, Told{"bright", 100 * (more.peak - 1)});
}

}  // namespace

std::vector<Evaluator> harmonics_evaluators() {
  return {{"sh-linear-loss", evaluate_loss}};
}

}  // namespace shadefit
