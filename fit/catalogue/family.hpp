#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fit/catalogue/published.hpp"
#include "fit/catalogue/surface.hpp"
#include "fit/errors/effect.hpp"
#include "fit/errors/extremum.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/scalars/symbolic.hpp"
#include "fit/steps/alternation.hpp"
#include "fit/steps/status.hpp"
#include "fit/study/study.hpp"

/// The forms that are fitted by name, and their fits. Each is a form of a study of studies/catalogue.
namespace shadefit {

struct Family;

/// The setting of a family: the exponent of a lobe, or the surface of a Fresnel form.
struct Setting {
  double exponent = 0;   ///< ignored if the family has none
  Surface surface = {};  ///< ignored if the form is not a Fresnel form

  // A bare exponent is the usual setting.
  constexpr Setting(double exponent_ = 0, Surface surface_ = {}) : exponent(exponent_), surface(surface_) {}
};

/// The result of a fit: constants, their digits, and the errors of the fitted curve.
struct Fit {
  std::vector<double> parameters;  ///< the free ones, in the order of the family; an answer only if converged
  Status status = Status::not_converged;
  int digits = 0;  ///< correct digits of the worst parameter, at most 14
  /// sqrt(integral of measure * (weight * error)^2 / integral of measure), with the error of the metric.
  /// Never above the largest weight * |error|.
  double rms_error = 0;
  std::optional<double> level = std::nullopt;      ///< of a minimax fit: the largest weight * |error|
  std::vector<AlternationPoint> alternation = {};  ///< of a minimax fit; by rising cosine
  std::string why = {};  ///< of a fit that did not converge, if its status is not enough
  const Family* family = nullptr;
  std::optional<double> exponent = std::nullopt;  ///< empty where the family has none
  Surface surface = {};                           ///< of a Fresnel form
  Metric metric = {};
  Extremum max_abs_error = {};  ///< of form - target
};

/// A form and its target. Parameters are in the order of `parameters`.
struct Family {
  std::string id, title;
  std::string variables;  ///< what each letter means
  std::string sweep;   ///< exponents to fit by default: numbers and A:B:STEP, by commas; empty: no exponent
  bool is_fresnel;     ///< the target is the weight of a reflectance
  bool is_comparison;  ///< no source names it: `fit` and `list` show it, a report only on request
  std::vector<std::string> parameters;
  Symbolic target, form;  ///< of the cosine c and the exponent k; the form of the parameters too
  Study
      study;  ///< its target, its form, and those near its peak; a Fresnel form has the target of its surface
  /// Three points, spread over the box of the search: formulas of k, or of the sharpness h of a Fresnel
  /// target; and those for a surface that is seen from inside, if there are others.
  std::vector<std::vector<Symbolic>> starts, starts_inside;

  bool has_exponent() const { return !sweep.empty(); }

  Fit fit(const Setting& setting, const Metric& metric) const;

  /// The largest weight * |error| on the domain of a metric, at the values of its free parameters. Infinite
  /// at a pole.
  Extremum largest_error(const Setting& setting, Metric metric, std::span<const double> values) const;

  /// Of a change of the parameters.
  Effect effect(const Setting& setting, const Domain& domain, std::span<const double> from,
                std::span<const double> to) const;

  /// The points from which a search starts: a value of each parameter, in their order.
  std::vector<std::vector<Held>> starts_of(const Setting& setting) const;
};

/// Why two errors of one curve are no answer: a root mean square is never above the largest magnitude, and
/// that is finite. Empty if they are one. So the search and the quadrature check each other.
std::string contradiction_of(double rms_error, double largest_error);

/// The setting that a fit was made with.
inline Setting setting_of(const Fit& fit) {
  return {fit.exponent.value_or(0), fit.surface};
}

/// The study of a family under a metric, with the formulas near its peak and the starts that are known. A
/// relative error is that of the family; that of a lobe counts where the target is at least 1/255, one code
/// of an 8-bit linear target. Empty if it has no meaning anywhere.
std::optional<Study> study_of(const Family& family, const Setting& setting, const Metric& metric);

/// Target and weight of a Fresnel form for a surface, over c. Without a named surface an absolute error is
/// that of the weight, for every f0; else errors are those of the reflectance. The range is cut where the
/// target has fallen.
Study fresnel_study(const Surface& surface, Error error);

/// Multiplies the weight of a study by another. An empty one changes nothing.
void multiply_weight(Study& study, const std::string& weight);

/// Every family, in the order of the report.
std::span<const Family> families();

/// The place of a parameter among the family's. Throws std::logic_error if the family has no such parameter.
std::size_t parameter_index(const Family& family, std::string_view name);

/// The family of that id, or null.
const Family* find_family(std::string_view id);

}  // namespace shadefit
