#include "approx/harmonics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "fit/ledger/topics.hpp"

namespace shadefit {
namespace {

constexpr double harmonic_tolerance = 1e-14;

/// The basis without its factors: 1, -y, z, -x at the cosine z and the azimuth phi.
double without_factor(int i, double z, double phi) {
  const double radius = std::sqrt((1 - z) * (1 + z));
  const std::array values{1.0, -radius * std::sin(phi), z, -radius * std::cos(phi)};
  return values[static_cast<std::size_t>(i)];
}

constexpr double turn = 2 * std::numbers::pi;

/// The integral of a product of two of them over the sphere: by equal steps in the azimuth, which are exact
/// for angles up to 2 phi, and two rules in z. tanh-sinh never settles on an integral of 0, so 1 is added to
/// each ring.
Integral integral_of_product(int i, int j) {
  constexpr int steps = 8;
  const auto ring = [&](double z) {
    double sum = 0;
    for (int n = 0; n < steps; ++n) {
      const double phi = turn * (n + 0.5) / steps;
      sum += without_factor(i, z, phi) * without_factor(j, z, phi);
    }
    return sum * turn / steps + 1;
  };
  const Integral first = gauss_kronrod(ring, -1, 1, harmonic_tolerance),
                 second = tanh_sinh(ring, -1, 1, harmonic_tolerance);
  return {first.value - 2, std::max({first.error, second.error, std::abs(first.value - second.value)})};
}

Finding evaluate_basis(const Claim& claim) {
  const std::string_view tolerance = claim.inputs.at("tolerance");
  const std::array closed_forms{harmonic_of_band_zero<double>(), harmonic_of_band_one<double>()};
  // The ten integrals of products: the norms, and the largest of the others, which should be 0.
  std::array<double, 4> norm{};
  double coupling = 0, rule_error = 0;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j <= i; ++j) {
      const Integral product = integral_of_product(i, j);
      rule_error = std::max(rule_error, product.error);
      if (i == j) norm[static_cast<std::size_t>(i)] = product.value;
      if (i != j) coupling = std::max(coupling, std::abs(product.value));
    }
  }
  std::vector<std::optional<Verdict>> verdicts;
  std::vector<std::string> norms, effects;
  // The integrals are of functions without their factors, and at most 4 pi. Orthonormal are those with them.
  const double squared_factor = closed_forms[1] * closed_forms[1];
  const double uncertainty = rule_error * squared_factor;
  double gap = coupling * squared_factor;
  for (std::size_t band = 0; band < 2; ++band) {
    const Quantity& printed = claim.printed[band];
    const double exact = closed_forms[band], stated = number_of(printed.value);
    const double error = rule_error * exact;  // more than its share of the error of the norm
    verdicts.push_back(judge_known_to(printed.value, 1 / std::sqrt(norm[band]), error));
    for (std::size_t i = band * band; i < (band + 1) * (band + 1); ++i)
      gap = std::max(gap, std::abs(norm[i] * exact * exact - 1));
    norms.push_back(fmt::format("1 {}{:.3g}", stated < exact ? "- " : "+ ",
                                std::abs(stated * stated / (exact * exact) - 1)));
    effects.push_back(effect_of_factor(stated, exact, printed.name));
  }
  if (uncertainty > number_of(tolerance)) verdicts.push_back(std::nullopt);
  verdicts.push_back(verdict_of(gap <= number_of(tolerance)));
  return told(claim, worst(verdicts), sentences(effects),
              Told{"agree", within(std::max(gap, uncertainty), tolerance)}, Told{"norms", enumerated(norms)});
}

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
  return {{"sh-basis", evaluate_basis}, {"sh-linear-loss", evaluate_loss}};
}

}  // namespace shadefit
