#include "fit/claims/normalisation_check.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "approx/normalisation.hpp"
#include "fit/quadrature/integrate.hpp"
#include "fit/quadrature/substitution.hpp"
#include "fit/scalars/jet.hpp"
#include "fit/support/root.hpp"

namespace shadefit {
namespace {

/// Two rules in two variables: Gauss-Kronrod over the cosine, tanh-sinh over the angle. A sharp lobe is cut
/// off where it has fallen to exp(-48). Lobes are monotonic, so the rest is at most the lobe there times the
/// rest of y. Relative tolerance 1e-14: two digits below the promise, and one above the rounding of the sums.
template <class Lobe>
NormalisationCheck check(double alpha) {
  constexpr double tolerance = 1e-14;
  constexpr double azimuth = 2 * std::numbers::pi;
  const double sharpness = Lobe::sharpness * alpha;
  const auto density = [&](const auto& place) {
    return azimuth * Lobe::lobe(place.cosine.one_minus_cos, alpha) * place.density;
  };

  const Substitution cosine({.measure = Measure::cosine}, {.concentration = sharpness, .end_power = alpha});
  const Integral by_cosine = gauss_kronrod([&](double s) { return density(cosine.at(s)); }, 0, 1, tolerance);

  const Substitution angle({.measure = Measure::angle}, {.concentration = sharpness});
  const auto over_angle = [&](double s) {
    const auto place = angle.at(s);
    const double y = place.cosine.one_minus_cos;
    return density(place) * std::sqrt(y * (2 - y));
  };
  const Integral by_angle = tanh_sinh(over_angle, 0, 1, tolerance);

  const Cosine<double> end = cosine.at(1.0).cosine;
  const double tail = azimuth * Lobe::lobe(end.one_minus_cos, alpha) * end.cos_theta;
  const double constant = Lobe::constant(alpha);
  const double difference = std::abs(constant * by_cosine.value - 1);
  const double estimated_error =
      (std::abs(by_cosine.value - by_angle.value) + std::max(by_cosine.error, by_angle.error) + tail) /
      by_cosine.value;
  return {.record = &Lobe::record,
          .exponent = Lobe::record.has_exponent ? std::optional(alpha) : std::nullopt,
          .closed_form = constant,
          .integral = 1 / by_cosine.value,
          .relative_difference = difference,
          .estimated_error = estimated_error,
          .verdict = judge_normalisation(difference, estimated_error, Lobe::record.closeness)};
}

template <class Lobe>
void append_checks(std::vector<NormalisationCheck>& checks, const Normalisation& record,
                   std::span<const double> exponents) {
  if (record.id != Lobe::record.id) return;
  if (!record.has_exponent) {
    checks.push_back(check<Lobe>(1));
    return;
  }
  for (const double alpha : exponents) checks.push_back(check<Lobe>(alpha));
}

}  // namespace

std::vector<NormalisationCheck> check_normalisation(const Normalisation& record,
                                                    std::span<const double> exponents) {
  std::vector<NormalisationCheck> checks;
  [&]<class... Lobe>(std::type_identity<std::tuple<Lobe...>>) {
    (append_checks<Lobe>(checks, record, exponents), ...);
  }(std::type_identity<NormalisedLobes>{});
  return checks;
}

std::optional<Verdict> judge_normalisation(double relative_difference, double estimated_error,
                                           double closeness) {
  if (!(estimated_error <= normalisation_tolerance)) return std::nullopt;
  const double allowed = std::max(normalisation_tolerance, closeness);
  return relative_difference <= allowed ? Verdict::confirmed : Verdict::refuted;
}

LargestRatio largest_cheap_ratio() {
  using Jet = ceres::Jet<double, 1>;
  const auto ratio = [](const auto& log2_alpha) {
    const auto alpha = exp2(log2_alpha);
    return BlinnPhongCheapLobe::constant(alpha) / BlinnPhongBrdfLobe::constant(alpha);
  };
  const auto slope = [&](double log2_alpha) { return ratio(Jet(log2_alpha, 0)).v[0]; };
  LargestRatio largest{0, 1};  // the limit of the ratio at either end
  constexpr double step = 0.125;
  for (double left = -10; left < 20; left += step) {
    if (!(slope(left) > 0 && slope(left + step) <= 0)) continue;
    const double at = root_between(slope, left, left + step, 53);
    if (ratio(at) > largest.ratio) largest = {std::exp2(at), ratio(at)};
  }
  return largest;
}

}  // namespace shadefit
