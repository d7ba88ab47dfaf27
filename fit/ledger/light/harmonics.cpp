#include "approx/harmonics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "approx/encoding.hpp"
#include "fit/errors/effect.hpp"
#include "fit/ledger/agreement.hpp"
#include "fit/ledger/told.hpp"
#include "fit/ledger/topics.hpp"
#include "fit/quadrature/integrate.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/format.hpp"

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

/// The ten integrals of products: the norms, and the largest of the others, which should be 0.
struct Orthogonality {
  std::array<double, 4> norm{};
  double coupling = 0;  ///< the largest between two different functions
  double error = 0;     ///< estimated, and the distance of the two rules
};

Orthogonality integrate_products() {
  Orthogonality result;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j <= i; ++j) {
      const Integral product = integral_of_product(i, j);
      result.error = std::max(result.error, product.error);
      if (i == j) {
        result.norm[static_cast<std::size_t>(i)] = product.value;
      } else {
        result.coupling = std::max(result.coupling, std::abs(product.value));
      }
    }
  }
  return result;
}

Finding evaluate_basis(const Claim& claim) {
  const std::string_view tolerance = claim.inputs.at("tolerance");
  const Orthogonality products = integrate_products();
  const std::array closed_forms{harmonic_of_band_zero<double>(), harmonic_of_band_one<double>()};
  std::vector<std::optional<Verdict>> verdicts;
  std::vector<std::string> computed, norms, effects;
  // The integrals are of functions without their factors, and at most 4 pi. Orthonormal are those with them.
  const double squared_factor = closed_forms[1] * closed_forms[1];
  const double uncertainty = products.error * squared_factor;
  double gap = products.coupling * squared_factor;
  for (std::size_t band = 0; band < 2; ++band) {
    const Quantity& printed = claim.printed[band];
    const double exact = closed_forms[band], stated = number_of(printed.value);
    const double error = products.error * exact;  // more than its share of the error of the norm
    verdicts.push_back(judge_known_to(printed.value, 1 / std::sqrt(products.norm[band]), error));
    for (std::size_t i = band * band; i < (band + 1) * (band + 1); ++i)
      gap = std::max(gap, std::abs(products.norm[i] * exact * exact - 1));
    computed.push_back(fmt::format("{} = {:.10g}", printed.name, exact));
    norms.push_back(fmt::format("1 {}{:.3g}", stated < exact ? "- " : "+ ",
                                std::abs(stated * stated / (exact * exact) - 1)));
    effects.push_back(effect_of_factor(stated, exact, printed.name));
  }
  if (uncertainty > number_of(tolerance)) verdicts.push_back(std::nullopt);
  verdicts.push_back(verdict_of(gap <= number_of(tolerance) || uncertainty > number_of(tolerance)));
  return {worst(verdicts), enumerated(computed),
          told(claim, Told{"agree", within(std::max(gap, uncertainty), tolerance)},
               Told{"norms", enumerated(norms)}),
          sentences(effects)};
}

Finding evaluate_memory(const Claim& claim) {
  const auto input = [&](std::string_view name) { return std::lround(given(claim, name)); };
  const long bits = input("channels") * input("coefficients") * input("bits");
  const long bytes = bits * input("width") * input("height") / 8;
  const std::string_view printed = claim.printed[0].value;
  const double decimal_megabytes = static_cast<double>(bytes) / 1e6;
  const double binary_megabytes = static_cast<double>(bytes) / 0x1p20;
  const Verdict verdict = units_off(printed, decimal_megabytes) == 0  ? Verdict::confirmed
                          : units_off(printed, binary_megabytes) == 0 ? Verdict::other_objective
                                                                      : Verdict::refuted;
  const std::string sizes =
      fmt::format("{:.6g} MB of 10^6 bytes, {:.6g} MiB of 2^20 bytes", decimal_megabytes, binary_megabytes);
  return {verdict, sizes,
          fmt::format("{:.6g} bytes per pixel are {:.10g} bytes in all: {}{}", static_cast<double>(bits) / 8,
                      static_cast<double>(bytes), sizes,
                      verdict == Verdict::other_objective
                          ? ". The printed digits are those of the other objective: binary megabytes"
                          : "")};
}

/// The part of the clamped cosine in its first bands.
struct Kept {
  double energy = 0;          ///< share of the squared norm
  double peak = 0;            ///< value towards the light, where the original is 1
  std::vector<double> peaks;  ///< the sums up to each band

  /// The projection of max(cos theta, 0).
  double at(double cos_theta) const {
    double sum = 0;
    for (std::size_t band = 0; band < peaks.size(); ++band)
      sum += peaks[band] * legendre_polynomial(static_cast<int>(band), cos_theta);
    return sum;
  }
};

/// The effect of keeping only those bands on a white surface, at every degree from the light.
std::string effect_of_keeping(const Kept& kept, std::string_view coefficients) {
  Effect effect;
  for (int degrees = 0; degrees <= 180; ++degrees) {
    const double cosine = std::cos(degrees * std::numbers::pi / 180);
    effect.show(std::max(0.0, cosine), kept.at(cosine),
                {{"theta = ", static_cast<double>(degrees), " degrees"}});
  }
  return sentence(effect, "the light on a white surface",
                  fmt::format("keeping {} coefficients", coefficients));
}

/// Bands 0 .. bands - 1, from moments by two rules beside their closed form.
Kept keep_bands(int bands, Agreement& agreement) {
  Kept kept;
  for (int band = 0; band < bands; ++band) {
    const double moment = clamped_cosine_moment<double>(band);
    const auto integrand = [band](double c) { return c * legendre_polynomial(band, c); };
    // An odd moment beyond the first is 0, so moments plus 1 are compared.
    const auto shifted = [](Integral integral) { return Integral{integral.value + 1, integral.error}; };
    agreement.compare(moment + 1,
                      shifted(gauss_kronrod(integrand, 0, 1, harmonic_tolerance, harmonic_tolerance)),
                      tanh_sinh([&](double c) { return integrand(c) + 1; }, 0, 1, harmonic_tolerance));
    kept.energy += energy_of_band(band, moment);
    kept.peaks.push_back(peak_of_band(band, moment));
    kept.peak += kept.peaks.back();
  }
  return kept;
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
/// original, for up to `most` bands; 0 if there is none.
int bands_within_a_code(int most) {
  int enough = 0;
  double peak = 0;
  for (int band = 0; band < most; ++band) {
    peak += peak_of_band(band, clamped_cosine_moment<double>(band));
    // above 1 the code is clamped but the light is not: an excess counts like the same deficit
    const bool is_within = srgb_code(1.0) - srgb_code(1 - std::abs(peak - 1)) <= 1;
    if (!is_within) enough = 0;
    if (is_within && enough == 0) enough = band + 1;
  }
  return enough;
}

Finding evaluate_loss(const Claim& claim) {
  const auto bands_of = [&](std::string_view name) {
    return static_cast<int>(std::lround(std::sqrt(given(claim, name))));
  };
  const std::string_view tolerance = claim.inputs.at("tolerance");
  Agreement agreement;
  const Kept few = keep_bands(bands_of("coefficients"), agreement);
  const Kept more = keep_bands(bands_of("more coefficients"), agreement);
  const double little = given(claim, "a little");
  const bool is_little = few.energy < 1 && 1 - few.energy <= little;
  const bool is_closer = more.energy > few.energy && std::abs(more.peak - 1) < std::abs(few.peak - 1);
  const std::optional<Verdict> parts[] = {agreement.verdict(number_of(tolerance)), verdict_of(is_little),
                                          verdict_of(is_closer)};
  const auto words = [](const Kept& kept, std::string_view coefficients) {
    return fmt::format(
        "{} coefficients keep {} = {:.6g} of the energy of the clamped cosine, and make its value facing the "
        "light {} of "
        "the exact one",
        coefficients, as_fraction(kept.energy), kept.energy, as_fraction(kept.peak));
  };
  const int enough = bands_within_a_code(64);
  return {worst(parts),
          fmt::format("energy kept = {} and {}", as_fraction(few.energy), as_fraction(more.energy)),
          told(claim, Told{"few", words(few, claim.inputs.at("coefficients"))},
               Told{"more", words(more, claim.inputs.at("more coefficients"))},
               Told{"agree", within(agreement.gap, tolerance)},
               Told{"enough", static_cast<double>(enough * enough)},
               Told{"dark", srgb_code(1.0) - srgb_code(few.peak)}, Told{"bright", 100 * (more.peak - 1)}),
          sentences({effect_of_keeping(few, claim.inputs.at("coefficients")),
                     effect_of_keeping(more, claim.inputs.at("more coefficients"))})};
}

}  // namespace

std::vector<Evaluator> harmonics_evaluators() {
  return {
      {"sh-basis", evaluate_basis}, {"sh-buffer-memory", evaluate_memory}, {"sh-linear-loss", evaluate_loss}};
}

}  // namespace shadefit
