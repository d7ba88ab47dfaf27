#include "fit/claims/reflectance.hpp"

#include <cmath>

#include "fit/support/root.hpp"

namespace shadefit {
namespace {

/// Two digits below the promise, because the estimates of the rules are cautious.
constexpr double integral_tolerance = reflectance_tolerance / 100;

/// A lobe at one exponent: the common part of all its constants.
struct LobeIntegrals {
  std::vector<LobeIntegrand<double>> values;  ///< at the view angles
  std::vector<LobeIntegrand<double>> errors;  ///< relative
  ReflectancePeak largest;
  ReflectancePeak largest_with_cosine;
};

double relative_error(const Integral& a, const Integral& b) {
  return (std::abs(a.value - b.value) + a.error + b.error) / a.value;
}

std::function<double(double)> over_view(ReflectedLobe lobe, double alpha,
                                        double LobeIntegrand<double>::*part) {
  return [=](double degrees) {
    return reflect_by_circles(lobe, alpha, View(degrees), part, integral_tolerance).value;
  };
}

ReflectancePeak peak_among(ReflectedLobe lobe, double alpha, std::span<const double> angles,
                           const std::vector<LobeIntegrand<double>>& values,
                           double LobeIntegrand<double>::*part) {
  std::vector<ReflectancePeak> samples;
  for (std::size_t i = 0; i < angles.size(); ++i) samples.push_back({values[i].*part, angles[i]});
  return largest_over_view(over_view(lobe, alpha, part), samples);
}

LobeIntegrals integrate_lobe(ReflectedLobe lobe, double alpha, std::span<const double> angles) {
  LobeIntegrals result;
  for (const double degrees : angles) {
    const View view(degrees);
    const auto circles = reflect_by_circles(lobe, alpha, view, integral_tolerance);
    const auto longitude = reflect_by_longitude(lobe, alpha, view, integral_tolerance);
    result.values.push_back({circles.plain.value, circles.with_cosine.value});
    result.errors.push_back({relative_error(circles.plain, longitude.plain),
                             relative_error(circles.with_cosine, longitude.with_cosine)});
  }
  result.largest = peak_among(lobe, alpha, angles, result.values, &LobeIntegrand<double>::plain);
  result.largest_with_cosine =
      peak_among(lobe, alpha, angles, result.values, &LobeIntegrand<double>::with_cosine);
  return result;
}

/// The view angle from which on the reflectance with n.l is at most 1. It lies between the last known place
/// above 1 (a view angle of the table, or the peak) and the next place; the horizon if there is none.
std::optional<double> conserving_from(ReflectedLobe lobe, double alpha, double factor,
                                      const std::vector<Reflectance>& points, const ReflectancePeak& peak) {
  std::vector<ReflectancePeak> known{peak};
  for (const Reflectance& point : points) known.push_back({point.with_cosine, point.view_angle});
  std::ranges::sort(known, {}, &ReflectancePeak::view_angle);
  const auto last = std::find_if(known.rbegin(), known.rend(),
                                 [](const auto& place) { return place.value > 1 + energy_tolerance; });
  if (last == known.rend()) return std::nullopt;
  if (last == known.rbegin()) return 90;
  const auto next = last - 1;
  if (next->value >= 1) return next->view_angle;  // there it is 1
  const auto integral = over_view(lobe, alpha, &LobeIntegrand<double>::with_cosine);
  return root_between([&](double degrees) { return factor * integral(degrees) - 1; }, last->view_angle,
                      next->view_angle, 40);
}

ReflectanceCurve curve_of(const ReflectedConstant& constant, double alpha, double factor,
                          std::span<const double> angles, const LobeIntegrals& integrals) {
  const auto scaled = [&](ReflectancePeak peak) {
    return ReflectancePeak{factor * peak.value, peak.view_angle};
  };
  ReflectanceCurve curve{constant.record, alpha, {}, {}, scaled(integrals.largest_with_cosine), {}};
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const auto& value = integrals.values[i];
    const auto& error = integrals.errors[i];
    const double with_cosine = factor * value.with_cosine;
    curve.points.push_back(
        {angles[i], constant.has_cosine ? with_cosine : factor * value.plain, with_cosine,
         constant.has_cosine ? error.with_cosine : std::max(error.plain, error.with_cosine)});
  }
  curve.largest = constant.has_cosine ? curve.largest_with_cosine : scaled(integrals.largest);
  curve.conserves_from =
      conserving_from(constant.lobe, alpha, factor, curve.points, curve.largest_with_cosine);
  return curve;
}

}  // namespace

ReflectanceCurve reflectance_curve(const ReflectedConstant& constant, double exponent, double factor,
                                   std::span<const double> angles) {
  return curve_of(constant, exponent, factor, angles, integrate_lobe(constant.lobe, exponent, angles));
}

std::vector<ReflectanceCurve> reflectance_curves(const std::function<bool(std::string_view)>& is_wanted) {
  std::vector<ReflectanceCurve> curves;
  for (const ReflectedLobe lobe : {ReflectedLobe::phong, ReflectedLobe::blinn_phong}) {
    std::vector<LobeIntegrals> integrals;
    for (const ReflectedConstant& constant : reflected_constants) {
      if (constant.lobe != lobe || !is_wanted(constant.record->id)) continue;
      if (integrals.empty()) {
        for (const double alpha : reflectance_exponents)
          integrals.push_back(integrate_lobe(lobe, alpha, view_angles));
      }
      for (std::size_t i = 0; i < reflectance_exponents.size(); ++i) {
        const double alpha = reflectance_exponents[i];
        curves.push_back(curve_of(constant, alpha, constant.constant(alpha), view_angles, integrals[i]));
      }
    }
  }
  return curves;
}

}  // namespace shadefit
