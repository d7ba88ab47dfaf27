#include "fit/squares/solve_in_units.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "fit/scalars/likely_sizes.hpp"
#include "fit/steps/digits.hpp"
#include "fit/study/study_nodes.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// The unit of the target, with an empty name, and those of variable and parameters: powers of two.
using Units = std::map<std::string, double>;

Units units_of_range(const ReadStudy& study) {
  const StudyAxis& axis = study.axes.front();
  const auto octaves = [](double size) { return size > 0 ? std::ilogb(size) : 0; };
  double largest = 0;
  for (const double value : values_at_nodes(study, study.target, nodes_of(study, edges_of(study), 14)))
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  Units units{{axis.variable, octaves(std::max(std::abs(axis.lower), std::abs(axis.upper)))},
              {"", octaves(largest)}};
  const auto sizes = likely_sizes(study.form, study.parameters, units, units[""]);
  for (std::size_t i = 0; i < sizes.size(); ++i) units[study.parameters[i]] = std::round(sizes[i]);
  return units;
}

/// The units of a study of which some number is far from 1.
std::optional<Units> far_units(const ReadStudy& study) {
  // The square of an eighth power of a size nearer to 1 is still a double.
  constexpr double far = 32;
  if (study.rows || study.axes.size() > 1 || study.residual) return std::nullopt;
  Units units = units_of_range(study);
  const auto is_near = [](const auto& unit) { return std::abs(unit.second) <= far; };
  return std::ranges::all_of(units, is_near) ? std::nullopt : std::optional(std::move(units));
}

Symbolic times_power_of_two(const Symbolic& e, double exponent) {
  return exponent == 0 ? e : Symbolic::integer_power(Symbolic::number("2"), static_cast<int>(exponent)) * e;
}

/// A number in its units, or with `sign` 1 what a number of these units is in those of the user.
double moved(double value, double unit, int sign) {
  return std::ldexp(value, sign * static_cast<int>(unit));
}

ReadStudy in_units(ReadStudy study, const Units& units) {
  const auto substituted = [&](const Symbolic& formula) {
    return evaluate<Symbolic>(formula, [&](const std::string& name) {
      return times_power_of_two(Symbolic::variable(name), units.at(name));
    });
  };
  StudyAxis& axis = study.axes.front();
  axis.lower = moved(axis.lower, units.at(axis.variable), -1);
  axis.upper = moved(axis.upper, units.at(axis.variable), -1);
  for (double& cut : axis.cuts) cut = moved(cut, units.at(axis.variable), -1);
  for (ParameterBounds& bounds : study.bounds) {
    bounds.lower = moved(bounds.lower, units.at(bounds.parameter), -1);
    bounds.upper = moved(bounds.upper, units.at(bounds.parameter), -1);
  }
  axis.density = substituted(axis.density);
  study.target = times_power_of_two(substituted(study.target), -units.at(""));
  study.form = times_power_of_two(substituted(study.form), -units.at(""));
  study.weight = substituted(study.weight);
  return study;
}

/// A fit of that study as one of the study itself.
StudyFit in_own_units(const ReadStudy& study, const Units& units, StudyFit fit) {
  // If the error is down to the rounding of 50 digits, a zero may be what they do not show.
  constexpr double exact = 1e-36;
  constexpr long double of_50_digits = 1e-47L;
  const double of_x = units.at(study.axes.front().variable), of_target = units.at("");
  const double of_error = study.error == Error::relative ? 0 : of_target;
  for (std::size_t i = 0; i < study.parameters.size(); ++i) {
    const double unit = units.at(study.parameters[i]);
    if (fit.rms_error < exact && fit.parameters[i] == 0)
      fit.digits = std::min(fit.digits, correct_digits(std::ldexp(of_50_digits, static_cast<int>(unit))));
    fit.parameters[i] = moved(fit.parameters[i], unit, 1);
  }
  if (fit.digits < least_study_digits)
    fail(fit, Status::not_converged, "a parameter is beyond the digits of the target");
  fit.max_abs_error = {moved(fit.max_abs_error.magnitude, of_target, 1),
                       {moved(fit.max_abs_error.at.front(), of_x, 1)}};
  fit.rms_error = moved(fit.rms_error, of_error, 1);
  if (fit.level) fit.level = moved(*fit.level, of_error, 1);
  for (AlternationPoint& point : fit.alternation) {
    point.at.cos_theta = moved(point.at.cos_theta, of_x, 1);
    point.error = moved(point.error, of_error, 1);
  }
  return fit;
}

}  // namespace

bool needs_units(const ReadStudy& study) {
  return far_units(study).has_value();
}

StudyFit solve_in_units(const ReadStudy& study, const std::vector<Held>& starts, const SolveStudy& solve) {
  const std::optional<Units> units = far_units(study);
  if (!units) return solve(study, starts);
  std::vector<Held> from = starts;
  for (Held& start : from) start.value = moved(start.value, units->at(start.parameter), -1);
  try {
    const StudyFit fit = solve(in_units(study, *units), from);
    if (fit.status == Status::converged) return in_own_units(study, *units, fit);
  } catch (const UserError&) {
    // In the study's own units the same fault has the numbers that its user knows.
  }
  return solve(study, starts);
}

}  // namespace shadefit
