#pragma once

#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "approx/normalisation.hpp"
#include "fit/errors/extremum.hpp"
#include "fit/integrals/directional_reflectance.hpp"

/// The directional reflectance of the normalised lobes at every view angle, and whether they create energy.
namespace shadefit {

/// A constant whose reflectance is followed over the view angle.
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

/// The relative error that a reflectance stays below, both rules' estimates and their difference together.
/// The rules agree to 1e-13; what is left of the bound is the caution of their estimates at flat views.
inline constexpr double reflectance_tolerance = 1e-10;

/// A reflectance that exceeds 1 by no more than this is 1.
inline constexpr double energy_tolerance = 1e-9;

/// At one view angle.
struct Reflectance {
  double view_angle;       ///< in degrees
  double reflectance;      ///< of the lobe as the constant is stated for it
  double with_cosine;      ///< of that lobe times n.l; the same where it has the factor already
  double estimated_error;  ///< relative, of the worse of both
};

/// Where a reflectance is largest.
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
  /// The view angle in degrees from which on the reflectance with n.l stays at most 1; empty where it never
  /// exceeds 1, so that no energy is created.
  std::optional<double> conserves_from;
};

/// The curves of those constants that `is_wanted` says, in the order of `reflected_constants`, each at the
/// `reflectance_exponents`. Integrals that constants share are computed once.
std::vector<ReflectanceCurve> reflectance_curves(const std::function<bool(std::string_view id)>& is_wanted);

/// The curve of one constant at one exponent, at those view angles in degrees, which rise from 0 to below 90.
/// `factor` stands for the constant: its own value there, or another's that is tried in its place.
ReflectanceCurve reflectance_curve(const ReflectedConstant& constant, double exponent, double factor,
                                   std::span<const double> angles);

/// Where f, a function of the view angle, is largest between the first and the last sample. Sampled: at
/// `samples`, which rise in angle, then at three more places to either side of the largest, then refined.
/// Among values equal within `equal_extrema` the smallest angle counts. A peak closer to an end than the
/// nearest of these places passes for that end.
template <class F>
ReflectancePeak largest_over_view(const F& f, std::vector<ReflectancePeak> samples) {
  const auto by_value = [](const auto& a, const auto& b) { return a.value < b.value; };
  const auto best = [&] {
    const double largest = std::max_element(samples.begin(), samples.end(), by_value)->value;
    return std::find_if(samples.begin(), samples.end(),
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
  std::sort(samples.begin(), samples.end(),
            [](const auto& a, const auto& b) { return a.view_angle < b.view_angle; });
  const auto peak = best();
  if (peak == samples.begin() || peak + 1 == samples.end()) return *peak;
  // Half the bits of a double: a value that is flat at its top has no more of its place.
  std::uintmax_t steps = 50;
  const auto found = boost::math::tools::brent_find_minima(
      [&](double angle) { return -f(angle); }, (peak - 1)->view_angle, (peak + 1)->view_angle, 26, steps);
  return {-found.second, found.first};
}

}  // namespace shadefit
