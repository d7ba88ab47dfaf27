#include "fit/normalisation_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "approx/normalisation.hpp"
#include "fit/integrate.hpp"
#include "fit/substitution.hpp"

namespace shadefit {
namespace {

/// The two rules share nothing but the lobe: Gauss-Kronrod runs over the cosine, tanh-sinh over the angle.
/// Relative tolerance 1e-14: two digits below what is promised, and one above the rounding of the sums.
template <class Lobe>
NormalisationCheck check(const Normalisation& record, double alpha) {
  constexpr double tolerance = 1e-14;
  constexpr double azimuth = 2 * std::numbers::pi;
  const double sharpness = Lobe::sharpness * alpha;

  const Substitution cosine({.measure = Measure::cosine}, {.concentration = sharpness, .end_power = alpha});
  const Integral by_cosine = gauss_kronrod(
      [&](double s) {
        const auto place = cosine.at(s);
        return azimuth * Lobe::lobe(place.cosine.one_minus_cos, alpha) * place.density;
      },
      0, 1, tolerance);

  const Substitution angle({.measure = Measure::angle}, {.concentration = sharpness});
  const Integral by_angle = tanh_sinh(
      [&](double s) {
        const auto place = angle.at(s);
        const double y = place.cosine.one_minus_cos;
        const double sin_theta = std::sqrt(y * (2 - y));
        return azimuth * sin_theta * Lobe::lobe(y, alpha) * place.density;
      },
      0, 1, tolerance);

  // What lies beyond the cut, relative to the whole, is exp(-decay) = 1e-21: below every rounding.
  const double constant = Lobe::constant(alpha);
  const double difference = std::abs(constant * by_cosine.value - 1);
  const double estimated_error =
      (std::abs(by_cosine.value - by_angle.value) + std::max(by_cosine.error, by_angle.error)) /
      by_cosine.value;
  return {&record,
          record.has_exponent ? std::optional(alpha) : std::nullopt,
          constant,
          1 / by_cosine.value,
          difference,
          estimated_error,
          judge_normalisation(difference, estimated_error)};
}

using Check = NormalisationCheck (*)(const Normalisation&, double);

Check check_of(std::string_view id) {
  if (id == "norm-lambert") return &check<LambertLobe>;
  if (id == "norm-phong") return &check<PhongLobe>;
  if (id == "norm-phong-brdf") return &check<PhongBrdfLobe>;
  if (id == "norm-blinn-phong") return &check<BlinnPhongLobe>;
  if (id == "norm-blinn-phong-brdf") return &check<BlinnPhongBrdfLobe>;
  if (id == "norm-ndf") return &check<DistributionLobe>;
  throw std::logic_error("a normalisation record without a lobe");
}

}  // namespace

std::vector<NormalisationCheck> check_normalisation(const Normalisation& record) {
  const Check check = check_of(record.id);
  if (!record.has_exponent) return {check(record, 1)};
  std::vector<NormalisationCheck> checks;
  for (const double alpha : normalisation_exponents) checks.push_back(check(record, alpha));
  return checks;
}

Verdict judge_normalisation(double relative_difference, double estimated_error) {
  const bool is_right =
      relative_difference <= normalisation_tolerance && estimated_error <= normalisation_tolerance;
  return is_right ? Verdict::confirmed : Verdict::refuted;
}

}  // namespace shadefit
