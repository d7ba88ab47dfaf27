#pragma once

#include <array>
#include <compare>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "fit/support/decimal.hpp"

/// The metric: a constant is right only under a measure, a norm, an error and a domain. Solver, report and
/// tests share one object of this file.
namespace shadefit {

/// How the domain is weighted. All are given for c = cos(theta).
enum class Measure {
  cosine,           ///< dc: uniform in the cosine, that is in solid angle
  angle,            ///< d theta = dc / sqrt(1 - c^2): uniform in the angle
  cosine_weighted,  ///< c dc: uniform in projected solid angle
};

enum class Norm {
  least_squares,  ///< the integral of measure * error^2 is least
  minimax,        ///< the largest |error| is least; no measure counts
};

enum class Error {
  absolute,  ///< form - target
  relative,  ///< relative to what the family says: a lobe's target, the reflectance F of a Fresnel form
};

/// The side of its target on which a form must stay.
enum class Side { above, below };

/// How a form runs over its range, weakly.
enum class Course { falls, rises };

/// The range of c that counts, 0 <= lower < upper <= 1.
struct Domain {
  double lower = 0;
  double upper = 1;
  auto operator<=>(const Domain&) const = default;
};

/// "0.25:1", each end to its shortest round trip.
inline std::string to_text(const Domain& domain) {
  return to_text(domain.lower) + ":" + to_text(domain.upper);
}

/// A given parameter, which is not fitted.
struct Held {
  std::string parameter;
  double value = 0;
  auto operator<=>(const Held&) const = default;
};

/// The constraints of a fit. Families support `held` under both norms, the others except `monotone` under
/// minimax. Studies of one variable support all of them under both norms.
struct Constraints {
  std::vector<Held> held = {};                    ///< parameters with given values
  std::vector<double> exact_at = {};              ///< ends of the domain where the form is its target
  std::optional<Side> one_sided = std::nullopt;   ///< the form is never below, or never above, its target
  std::optional<double> at_most = std::nullopt;   ///< the form's value, all over the domain
  std::optional<double> at_least = std::nullopt;  ///< the same from below
  std::optional<Course> monotone = std::nullopt;  ///< the form never rises, or never falls
  auto operator<=>(const Constraints&) const = default;
};

struct Metric {
  Measure measure = Measure::cosine;
  Norm norm = Norm::least_squares;
  Error error = Error::absolute;
  Domain domain = {};
  std::string weight = {};  ///< the factor of the error, a formula in c; empty: 1
  Constraints constraints = {};
  auto operator<=>(const Metric&) const = default;
};

/// The measures, in the order in which a published value is tried.
inline constexpr std::array measures{Measure::cosine, Measure::angle, Measure::cosine_weighted};

/// A measure near the peak: y^(p-1) (1 + w y + ..) dy for y = 1 - c.
struct PeakExpansion {
  double p;
  double w;
};

/// dc = dy; d theta = dy / sqrt(2y - y^2) = (2y)^(-1/2) (1 + y/4 + ..) dy, up to a factor; c dc = (1 - y) dy.
constexpr PeakExpansion peak_expansion(Measure measure) {
  switch (measure) {
    case Measure::cosine:
      return {1, 0};
    case Measure::angle:
      return {0.5, 0.25};
    case Measure::cosine_weighted:
      return {1, -1};
  }
  throw std::logic_error("a measure without an expansion");
}

constexpr std::string_view name(Measure measure) {
  switch (measure) {
    case Measure::cosine:
      return "cosine";
    case Measure::angle:
      return "angle";
    case Measure::cosine_weighted:
      return "cosine-weighted";
  }
  throw std::logic_error("a measure without a name");
}

constexpr std::string_view name(Norm norm) {
  return norm == Norm::least_squares ? "least-squares" : "minimax";
}

constexpr std::string_view name(Error error) {
  return error == Error::absolute ? "absolute" : "relative";
}

constexpr std::string_view name(Side side) {
  return side == Side::above ? "above" : "below";
}

constexpr std::string_view name(Course course) {
  return course == Course::falls ? "falls" : "rises";
}

/// The constraints as a reader names them, each after a comma: ", b = -7, form <= 1".
inline std::string describe(const Constraints& constraints, const std::string& variable = "c") {
  std::string text;
  for (const Held& held : constraints.held) text += ", " + held.parameter + " = " + to_text(held.value);
  for (const double c : constraints.exact_at) text += ", exact at " + variable + " = " + to_text(c);
  if (constraints.one_sided)
    text += *constraints.one_sided == Side::above ? ", form >= target" : ", form <= target";
  if (constraints.at_most) text += ", form <= " + to_text(*constraints.at_most);
  if (constraints.at_least) text += ", form >= " + to_text(*constraints.at_least);
  if (constraints.monotone) text += ", form " + std::string(name(*constraints.monotone));
  return text;
}

/// A metric in words: the measure of a least-squares fit, or "minimax absolute error", which has no measure;
/// then the domain if it is not [0, 1], the weight and the constraints.
inline std::string describe(const Metric& metric) {
  std::string text;
  if (metric.norm == Norm::minimax) {
    text = "minimax " + std::string(name(metric.error)) + " error";
  } else {
    text = std::string(name(metric.measure)) + (metric.error == Error::relative ? ", relative error" : "");
  }
  if (metric.domain != Domain{}) text += " on " + to_text(metric.domain);
  if (!metric.weight.empty()) text += ", weight " + metric.weight;
  return text + describe(metric.constraints);
}

}  // namespace shadefit
