#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "approx/phase.hpp"
#include "fit/ledger/topics.hpp"

namespace shadefit {
namespace {

/// The allowed difference of the rules from the closed form and from each other, for integrals that are 1:
/// their tolerance is 1e-13 or less, and sums of about a hundred ordinates, each with a few roundings, stay
/// within ten times that.
constexpr double density_tolerance = 1e-12;

/// The integral over the sphere by two rules, each in its own variable; the error includes their difference.
/// Over the angle: the printed form, with the sign of g, in long double, where 1 + g^2 - 2 g c keeps 13
/// digits for |g| = 0.999. From the peak on: the robust form of |g|, with the sphere turned over for a
/// negative g.
Integral over_the_sphere(double signed_g) {
  if (!(std::abs(signed_g) < 1)) throw std::invalid_argument("g has to lie between -1 and 1, both excluded");
  const double around = 2 * pi<double>();
  const auto in_angle = [&](double theta) {
    const long double wide = theta;
    return static_cast<double>(around * std::sin(wide) *
                               henyey_greenstein(std::cos(wide), static_cast<long double>(signed_g)));
  };
  const Integral by_angle = tanh_sinh(in_angle, 0, pi<double>(), 1e-13);
  const double g = std::abs(signed_g);
  if (g == 0) return by_angle;  // no peak
  // 1-c = width (e^s - 1): from the peak on, the base grows by e every unit of s.
  const double width = (1 - g) * (1 - g) / (2 * g);
  const auto stretched = [&](double s) {
    return around * henyey_greenstein_near_peak(width * std::expm1(s), g) * width * std::exp(s);
  };
  const Integral by_stretch = gauss_kronrod(stretched, 0, std::log1p(2 / width), 1e-13);
  return {by_stretch.value, std::max(by_stretch.error, std::abs(by_stretch.value - by_angle.value))};
}

/// The printed form in single precision at every other degree, with the peak scaled to 1.
Effect effect_in_single(float g) {
  const auto exact = static_cast<double>(g);
  const double peak = henyey_greenstein_near_peak(0.0, exact);
  Effect effect;
  for (int degrees = 0; degrees <= 180; degrees += 2) {
    const double theta = degrees * pi<double>() / 180, half_sine = std::sin(theta / 2);
    const auto cosine = static_cast<float>(std::cos(theta));
    effect.show(henyey_greenstein_near_peak(2 * half_sine * half_sine, exact) / peak,
                static_cast<double>(henyey_greenstein(cosine, g)) / peak,
                {{"theta = ", static_cast<double>(degrees), " degrees"}, {"g = ", exact}});
  }
  return effect;
}

Finding phase_normalisation(const Claim& claim) {
  const std::vector<double> anisotropies = numbers_of(claim.inputs.at("g"));
  std::vector<std::optional<Verdict>> verdicts;
  double apart = 0, closed = 0;
  for (const double g : anisotropies) {
    const Integral found = over_the_sphere(g);
    closed = henyey_greenstein_within(2.0, std::abs(g));
    apart = std::max({apart, found.error, std::abs(found.value - closed)});
    verdicts.push_back(judge_known_to(claim.printed[0].value, closed, density_tolerance));
  }
  const auto [least, most] = std::ranges::minmax_element(anisotropies);
  const double sharpest = std::max(-*least, *most);
  const auto single = static_cast<float>(sharpest);
  // the relative error at the peak, where the printed form cancels most, of a value in single precision
  const auto error_at_peak = [single](float found) {
    return std::abs(
        static_cast<double>(found) / henyey_greenstein_near_peak(0.0, static_cast<double>(single)) - 1);
  };
  const double robust = error_at_peak(henyey_greenstein_near_peak(0.0F, single));
  constexpr double roundings = 6e-7;  // ten roundings of a float, one for each operation of the form
  return told(
      claim, apart <= density_tolerance ? worst(verdicts) : std::nullopt,
      sentence(effect_in_single(single), "a highlight of peak 1", "in single precision the printed form"),
      Told{"closed", closed}, Told{"values", counted(std::ssize(anisotropies), "value")},
      Told{"least", *least}, Told{"most", *most}, Told{"tolerance", density_tolerance},
      Told{"peak", henyey_greenstein_near_peak(0.0, sharpest)}, Told{"sharpest", sharpest},
      Told{"off", error_at_peak(henyey_greenstein(1.0F, single))},
      Told{"robust", robust <= roundings ? "by roundings only" : fmt::format("by {:.2g}", robust)});
}

}  // namespace

/// Densities over the sphere, which integrate to 1.
std::vector<Evaluator> density_evaluators() {
  return {{"hg-normalisation", phase_normalisation}};
}

}  // namespace shadefit
