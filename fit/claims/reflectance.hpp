#pragma once

#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "approx/normalisation.hpp"
#include "fit/claims/directional_reflectance.hpp"
#include "fit/errors/extremum.hpp"

/// The directional reflectance of the normalised lobes for each view angle, and whether they create energy.
namespace shadefit {

/// A constant whose reflectance is computed over the view angle.
struct ReflectedConstant {
  const Normalisation* record;
  ReflectedLobe lobe;
  bool has_cosine;  ///< its own lobe has the factor n.l
  double (*constant)(const double& alpha);
};

inline constexpr std::array reflected_constants{
    ReflectedConstant{&PhongLobe::record, ReflectedLobe::phong, false, PhongLobe::constant<double>},
    ReflectedConstant{&PhongBrdfLobe::record, ReflectedLobe::phong, true, PhongBrdfLobe::constant<double>},
    ReflectedConstant{&BlinnPhongLobe::record, ReflectedLobe::blinn_phong, false,
                      BlinnPhongLobe::constant<double>},
    ReflectedConstant{&BlinnPhongBrdfLobe::record, ReflectedLobe::blinn_phong, true,
                      BlinnPhongBrdfLobe::constant<double>},
    ReflectedConstant{&BlinnPhongCheapLobe::record, ReflectedLobe::blinn_phong, true,
                      BlinnPhongCheapLobe::constant<double>},
};

/// The view angles, in degrees, and the exponents of the table.
inline constexpr std::array view_angles{0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 80.0, 85.0, 88.0, 89.0, 89.9};
inline constexpr std::array reflectance_exponents{1.0, 8.0, 64.0, 2048.0};

/// The bound on a reflectance's relative error: the estimates of both rules plus their difference. The rules
/// agree to 1e-13; the rest of the bound is for their cautious estimates at flat views.
inline constexpr double reflectance_tolerance = 1e-10;

/// A reflectance that exceeds 1 by at most this counts as 1.
inline constexpr double energy_tolerance = 1e-9;

/// At one view angle.
struct Reflectance {
  double view_angle;       ///< in degrees
  double reflectance;      ///< of the lobe for which the constant is stated
  double with_cosine;      ///< of that lobe times n.l; the same if the lobe has this factor
  double estimated_error;  ///< relative, of the worse of both
};

/// The largest reflectance and its place.
struct ReflectancePeak {
  double value;
  double view_angle;  ///< in degrees
};

/// One constant at one exponent.
struct ReflectanceCurve {
  const Normalisation* record;
  double exponent;
  std::vector<Reflectance> points;  ///< at the view angles
  ReflectancePeak largest;
  ReflectancePeak largest_with_cosine;
  /// The view angle in degrees from which on the reflectance with n.l is at most 1; empty if it never exceeds
  /// 1: then no energy is created.
  std::optional<double> conserves_from;
};

/// The curves of the constants for which `is_wanted` is true, in the order of `reflected_constants`, each at
/// the `reflectance_exponents`. Shared integrals are computed once.
std::vector<ReflectanceCurve> reflectance_curves(const std::function<bool(std::string_view id)>& is_wanted);

/// The curve of one constant at one exponent, at those view angles in degrees, which rise from 0 to below 90.
/// `factor` is the value of the constant, or another value that is tested in its place.
ReflectanceCurve reflectance_curve(const ReflectedConstant& constant, double exponent, double factor,
                                   std::span<const double> angles);

/// The largest value of f, a function of the view angle, between the first and the last sample, and its
/// place. Sampled at `samples`, in rising order, then at three more places on both sides of the largest, then
/// refined. Among values equal within `equal_extrema` the smallest angle counts. A peak that is closer to an
/// end than the nearest place counts as at that end.
template <class F>
ReflectancePeak largest_over_view(const F& f, std::vector<ReflectancePeak> samples) {
  const auto best = [&] {
    const double largest = std::ranges::max_element(samples, {}, &ReflectancePeak::value)->value;
    return std::ranges::find_if(samples,
                                [&](const auto& s) { return s.value >= largest * (1 - equal_extrema); });
  };
  const auto first = best();
  const auto low = first == samples.begin() ? first : first - 1;
  const auto high = first + 1 == samples.end() ? first : first + 1;
  std::vector<ReflectancePeak> finer;
  for (auto left = low; left != high; ++left) {
    for (const double part : {0.25, 0.5, 0.75}) {
      const double angle = left->view_angle + part * ((left + 1)->view_angle - left->view_angle);
      finer.push_back({f(angle), angle});
    }
  }
  samples.insert(samples.end(), finer.begin(), finer.end());
  std::ranges::sort(samples, {}, &ReflectancePeak::view_angle);
  const auto peak = best();
  if (peak == samples.begin() || peak + 1 == samples.end()) return *peak;
  // Half the bits of a double: the place of a maximum has no more.
  std::uintmax_t steps = 50;
  const auto found = boost::math::tools::brent_find_minima(
      [&](double angle) { return -f(angle); }, (peak - 1)->view_angle, (peak + 1)->view_angle, 26, steps);
  return {-found.second, found.first};
}

}  // namespace shadefit
