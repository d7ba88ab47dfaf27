#include "approx/phase.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "fit/errors/effect.hpp"
#include "fit/ledger/topics.hpp"
#include "fit/quadrature/integrate.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/format.hpp"

namespace shadefit {
namespace {

/// The allowed difference of the rules from the closed form and from each other: their tolerance is 1e-13,
/// and sums of about a hundred ordinates, each with a few roundings, stay within ten times that.
constexpr double phase_agreement = 1e-12;

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

/// The relative error at the peak, where the printed form cancels most, of a value found in single precision.
double error_at_peak(float found, float g) {
  return std::abs(static_cast<double>(found) / henyey_greenstein_near_peak(0.0, static_cast<double>(g)) - 1);
}

Finding phase_normalisation(const Claim& claim) {
  const std::vector<double> anisotropies = numbers_of(claim.inputs.at("g"));
  std::vector<std::optional<Verdict>> verdicts;
  double apart = 0, closed = 0;
  for (const double g : anisotropies) {
    const Integral found = over_the_sphere(g);
    closed = henyey_greenstein_within(2.0, std::abs(g));
    apart = std::max({apart, found.error, std::abs(found.value - closed)});
    verdicts.push_back(judge_known_to(claim.printed[0].value, closed, phase_agreement));
  }
  const auto [least, most] = std::ranges::minmax_element(anisotropies);
  const auto magnitude = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const double sharpest = std::abs(*std::ranges::max_element(anisotropies, magnitude));
  const auto single = static_cast<float>(sharpest);
  const double off = error_at_peak(henyey_greenstein(1.0F, single), single);
  const double robust = error_at_peak(henyey_greenstein_near_peak(0.0F, single), single);
  constexpr double roundings = 6e-7;  // ten roundings of a float, one for each operation of the form
  return {
      apart <= phase_agreement ? worst(verdicts) : std::nullopt, decimal(closed, 10),
      fmt::format(
          "the closed form gives {:.10g} at {} of g from {:.6g} to {:.6g}. Two quadrature rules, one of "
          "them over the form as printed, agree with it {}. The peak is {:.4g} per steradian at |g| = "
          "{:.6g}. There, in single precision, the printed form is off by {:.2g} of its value; with (1-g)^2 "
          "+ 2 g (1-c) under the exponent 1.5 it is off {}",
          closed, counted(std::ssize(anisotropies), "value"), *least, *most,
          apart <= phase_agreement ? fmt::format("to {:.1g}", phase_agreement)
                                   : fmt::format("no better than to {:.1g}", apart),
          henyey_greenstein_near_peak(0.0, sharpest), sharpest, off,
          robust <= roundings ? "by roundings only" : fmt::format("by {:.2g}", robust)),
      sentence(effect_in_single(single), "a highlight of peak 1", "in single precision the printed form")};
}

}  // namespace

std::vector<Evaluator> phase_evaluators() {
  return {{"hg-normalisation", phase_normalisation}};
}

}  // namespace shadefit
