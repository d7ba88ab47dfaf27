#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "approx/records/record.hpp"
#include "fit/errors/effect.hpp"
#include "fit/errors/exact_fresnel.hpp"
#include "fit/errors/extremum.hpp"
#include "fit/families/surface.hpp"
#include "fit/least_squares/status.hpp"
#include "fit/minimax/alternation.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/scalars/symbolic.hpp"

/// One fit and its report, and the table of the families that can be fitted.
namespace shadefit {

/// What a family leaves open: the exponent of a lobe, the surface of a Fresnel form.
struct Setting {
  double exponent = 0;   ///< ignored where the family has none
  Surface surface = {};  ///< ignored where the family is not of Fresnel's

  // A bare exponent is the usual setting.
  constexpr Setting(double exponent_ = 0, Surface surface_ = {}) : exponent(exponent_), surface(surface_) {}
  auto operator<=>(const Setting&) const = default;
};

/// What a fit found, how far it may be trusted, and how wrong the fitted curve is.
struct Fit {
  const Family* family;
  std::optional<double> exponent;  ///< empty where the family has none
  Surface surface;                 ///< of a Fresnel form
  Metric metric;
  std::vector<double>
      parameters;  ///< in the order of the family's names; an answer only if `status` is converged
  Status status;
  int iterations;  ///< Ceres and Newton steps together
  int digits;      ///< correct digits of the worst parameter, at most 14
  /// sqrt(integral of measure * (weight * error)^2 / integral of measure * weight^2), the error as the metric
  /// says: a constant weight changes nothing, and it is never above the largest error.
  double rms_error;
  Extremum max_abs_error;                 ///< of form - target
  std::optional<Extremum> max_rel_error;  ///< of what `relative_to` says; empty where that has no meaning
  Domain relative_domain;                 ///< where it was looked for
  std::string relative_to;
  std::optional<double> level = std::nullopt;      ///< of a minimax fit: the largest weight * |error|
  std::vector<AlternationPoint> alternation = {};  ///< of a minimax fit
  std::string why = {};  ///< of a fit that did not converge, where its status does not say it all
};

/// A form beside its target at one cosine. On an exact surface both are Fresnel weights f, F = f0 + (1-f0) f.
struct CurvePoint {
  double target, form;
  double error;                          ///< form - target
  std::optional<double> relative_error;  ///< of what `Fit::relative_to` says; empty where it is not finite
};

/// A family behind plain functions; parameters are in the order of `parameters`.
struct FittableFamily {
  const Family& info;
  std::span<const std::string_view> parameters;
  Fit (*fit)(const Setting&, const Metric&);
  Extremum (*max_abs_error)(const Setting&, const Domain&, std::span<const double> parameters);
  std::optional<Extremum> (*max_rel_error)(const Setting&, const Domain&, std::span<const double> parameters);
  Effect (*effect)(const Setting&, const Domain&, std::span<const double> from, std::span<const double> to);
  /// What the metric makes least, at given parameters: the rms error, or the largest weight * |error|.
  double (*objective)(const Setting&, const Metric&, std::span<const double> parameters);

  Symbolic (*target)();  ///< of the cosine c and the exponent k
  Symbolic (*form)();    ///< and of the parameters

  /// Of a Fresnel form, how far it is from its target on a surface; null for others.
  ReflectanceError (*reflectance_error)(const Surface&, std::span<const double> parameters) = nullptr;

  /// The part of a domain in which a relative error has a meaning; empty where there is none.
  std::optional<Domain> (*relative_domain)(const Setting&, const Domain&) = nullptr;

  /// The curve at a cosine, at given parameters.
  CurvePoint (*point)(const Setting&, std::span<const double> parameters, const Cosine<double>&) = nullptr;

  bool is_fresnel() const { return reflectance_error != nullptr; }

  bool has_exponent() const { return !info.sweep.empty(); }
};

/// Why two errors of one curve cannot both be right: a root mean square is never above the largest magnitude.
/// Empty where they can.
std::string contradiction_of(double rms_error, double largest_error);

/// The setting that a fit was made with.
inline Setting setting_of(const Fit& fit) {
  return {fit.exponent.value_or(0), fit.surface};
}

/// Every family, in the order of the report.
std::span<const FittableFamily> fittable_families();

/// The place of a parameter among the family's. Throws std::logic_error where the family has none of that
/// name.
std::size_t parameter_index(const FittableFamily& family, std::string_view name);

/// The family of that id, or null.
const FittableFamily* find_family(std::string_view id);

}  // namespace shadefit
