#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "approx/records/record.hpp"
#include "fit/errors/effect.hpp"
#include "fit/errors/exact_fresnel.hpp"
#include "fit/errors/extremum.hpp"
#include "fit/families/surface.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/scalars/symbolic.hpp"
#include "fit/solution.hpp"

/// One fit and its result, and the families that can be fitted.
namespace shadefit {

/// The setting of a family: the exponent of a lobe, or the surface of a Fresnel form.
struct Setting {
  double exponent = 0;   ///< ignored if the family has none
  Surface surface = {};  ///< ignored if the form is not a Fresnel form

  // A bare exponent is the usual setting.
  constexpr Setting(double exponent_ = 0, Surface surface_ = {}) : exponent(exponent_), surface(surface_) {}
  auto operator<=>(const Setting&) const = default;
};

/// The result of a fit: constants, their digits, and the errors of the fitted curve.
struct Fit : Solution {
  const Family* family = nullptr;
  std::optional<double> exponent = std::nullopt;  ///< empty where the family has none
  Surface surface = {};                           ///< of a Fresnel form
  Metric metric = {};
  Extremum max_abs_error = {};  ///< of form - target
  /// Relative to `relative_to`; empty if that has no meaning.
  std::optional<Extremum> max_rel_error = std::nullopt;
  Domain relative_domain = {};  ///< the range of its search
  std::string relative_to = {};
};

/// A form beside its target at one cosine. On an exact surface both are Fresnel weights f, F = f0 + (1-f0) f.
struct CurvePoint {
  double target, form;
  double error;                          ///< form - target
  std::optional<double> relative_error;  ///< relative to `Fit::relative_to`; empty if it is not finite
};

/// A number that is to be small, at given parameters. One thread asks it at a time.
using Objective = std::function<double(std::span<const double> parameters)>;

/// A family behind plain functions; parameters are in the order of `parameters`.
struct FittableFamily {
  const Family& info;
  std::span<const std::string_view> parameters;
  Fit (*fit)(const Setting&, const Metric&);
  Extremum (*max_abs_error)(const Setting&, const Domain&, std::span<const double> parameters);
  std::optional<Extremum> (*max_rel_error)(const Setting&, const Domain&, std::span<const double> parameters);
  Effect (*effect)(const Setting&, const Domain&, std::span<const double> from, std::span<const double> to);
  /// The quantity that the metric minimises: the rms error, or the largest weight * |error|.
  Objective (*objective)(const Setting&, const Metric&);

  Symbolic (*target)();  ///< of the cosine c and the exponent k
  Symbolic (*form)();    ///< and of the parameters

  /// The error of a Fresnel form on a surface; null for others.
  ReflectanceError (*reflectance_error)(const Surface&, std::span<const double> parameters) = nullptr;

  /// The part of a domain in which a relative error has a meaning; empty where there is none.
  std::optional<Domain> (*relative_domain)(const Setting&, const Domain&) = nullptr;

  /// The curve at a cosine, at given parameters.
  CurvePoint (*point)(const Setting&, std::span<const double> parameters, const Cosine<double>&) = nullptr;

  bool is_fresnel() const { return reflectance_error != nullptr; }

  bool has_exponent() const { return !info.sweep.empty(); }
};

/// Why two errors of one curve cannot both be right: a root mean square is never above the largest magnitude.
/// Empty if they can.
std::string contradiction_of(double rms_error, double largest_error);

/// The setting that a fit was made with.
inline Setting setting_of(const Fit& fit) {
  return {fit.exponent.value_or(0), fit.surface};
}

/// Every family, in the order of the report.
std::span<const FittableFamily> fittable_families();

/// The place of a parameter among the family's. Throws std::logic_error if the family has no such parameter.
std::size_t parameter_index(const FittableFamily& family, std::string_view name);

/// The family of that id, or null.
const FittableFamily* find_family(std::string_view id);

}  // namespace shadefit
