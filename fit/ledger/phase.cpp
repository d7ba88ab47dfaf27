#include "approx/phase.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "fit/decimal.hpp"
#include "fit/effect.hpp"
#include "fit/integrate.hpp"
#include "fit/ledger/list.hpp"
#include "fit/ledger/topics.hpp"

namespace shadefit {
namespace {

/// How far the rules may be from the closed form and from each other: the peak of g = 0.999 is 5e-7 wide in
/// 1 - c, whose rounding at the ends of its interval then costs four digits of sixteen.
constexpr double agreement = 1e-10;

/// The integral over the sphere, 2 pi times that over y = 1 - c in [0, 2], for g >= 0, by two rules; in the
/// error also what they are apart.
Integral over_the_sphere(double g) {
  const auto density = [g](double y) { return 2 * pi<double>() * henyey_greenstein_near_peak(y, g); };
  const Integral plain = tanh_sinh(density, 0, 2, 1e-13);
  if (g == 0) return {plain.value, plain.error};
  const double width = (1 - g) * (1 - g) / (2 * g);  // y = width (e^s - 1) doubles the base at s = ln 2
  const auto stretched = [&](double s) { return density(width * std::expm1(s)) * width * std::exp(s); };
  const Integral smooth = gauss_kronrod(stretched, 0, std::log1p(2 / width), 1e-13);
  return {smooth.value, std::max(smooth.error, std::abs(smooth.value - plain.value))};
}

/// The largest relative error of the printed form in single precision, at the peak, where its base cancels.
double error_in_float(double g) {
  const auto single = static_cast<float>(std::abs(g));
  const double exact = henyey_greenstein_near_peak(0.0, static_cast<double>(single));
  return std::abs(static_cast<double>(henyey_greenstein(1.0F, single)) / exact - 1);
}

double robust_error_in_float(double g) {
  const auto single = static_cast<float>(std::abs(g));
  const double exact = henyey_greenstein_near_peak(0.0, static_cast<double>(single));
  return std::abs(static_cast<double>(henyey_greenstein_near_peak(0.0F, single)) / exact - 1);
}

Finding normalisation(const Claim& claim) {
  const std::vector<double> anisotropies = numbers_of(claim.inputs.at("g"));
  std::vector<std::optional<Verdict>> verdicts;
  double apart = 0, closed = 0;
  for (const double g : anisotropies) {
    // A negative g is the positive one with the sphere turned over.
    const Integral found = over_the_sphere(std::abs(g));
    closed = henyey_greenstein_within(2.0, g);
    apart = std::max({apart, found.error, std::abs(found.value - closed)});
    verdicts.push_back(judge_known_to(claim.printed[0].value, closed, agreement));
  }
  const auto [least, most] = std::minmax_element(anisotropies.begin(), anisotropies.end());
  const auto magnitude = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const double sharpest = std::abs(*std::max_element(anisotropies.begin(), anisotropies.end(), magnitude));
  const double off = error_in_float(sharpest);
  const bool robust_is_exact = robust_error_in_float(sharpest) <= 4e-7;  // a few roundings of 6e-8
  return {
      apart <= agreement ? worst(verdicts) : std::nullopt, decimal(closed, 10),
      "the closed form gives " + decimal(closed, 10) + " at " +
          counted(static_cast<long>(anisotropies.size()), "value") + " of g from " + decimal(*least, 6) +
          " to " + decimal(*most, 6) + "; two quadrature rules agree with it " +
          (apart <= agreement ? "to " + decimal(agreement, 1) : "no better than to " + decimal(apart, 1)) +
          "; the peak is " + decimal(henyey_greenstein_near_peak(0.0, sharpest), 4) +
          " per steradian at |g| = " + decimal(sharpest, 6),
      "none exactly; in single precision the printed form is off by " + decimal(off, 2) +
          " of its value at the peak of |g| = " + decimal(sharpest, 6) +
          ", with the base (1-g)^2 + 2 g (1-c) " + (robust_is_exact ? "by roundings only" : "no better")};
}

}  // namespace

std::span<const Evaluator> phase_evaluators() {
  static constexpr std::array evaluators{Evaluator{"hg-normalisation", normalisation}};
  return evaluators;
}

}  // namespace shadefit
