#include "fit/study/solve_in_units.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>

#include "fit/least_squares/least_squares.hpp"
#include "fit/scalars/likely_sizes.hpp"
#include "fit/study/even_grid.hpp"
#include "fit/study/study_nodes.hpp"
#include "fit/support/user_error.hpp"
#include "fit/tape/tape_program.hpp"

namespace shadefit {
namespace {

/// Units as powers of two, by the names of variables and parameters.
struct Units {
  std::map<std::string, int> of;
  int target = 0;
};

/// The size of the largest value of the target, at a few places: as a power of two.
int size_of_target(const ReadStudy& study) {
  constexpr int steps = 6;
  TapeProgram<double> target(tape_of(study.target, node_variables(study)), {});
  double largest = 0;
  for (const std::vector<double>& place : even_grid(study.axes, steps)) {
    target.run(place);
    if (std::isfinite(target.output(0))) largest = std::max(largest, std::abs(target.output(0)));
  }
  return largest > 0 ? std::ilogb(largest) : 0;
}

/// Empty if no unit is very far from 1.
std::optional<Units> units_of_range(const ReadStudy& study) {
  // The square of an eighth power of such a size is still a double.
  constexpr int far = 32;
  if (study.rows) return std::nullopt;
  Units units{{}, size_of_target(study)};
  std::map<std::string, double> sizes;
  for (const StudyAxis& axis : study.axes) {
    units.of[axis.variable] = std::ilogb(std::max(std::abs(axis.lower), std::abs(axis.upper)));
    sizes[axis.variable] = units.of[axis.variable];
  }
  const std::vector<double> likely = likely_sizes(study.form, study.parameters, sizes, units.target);
  for (std::size_t i = 0; i < likely.size(); ++i)
    units.of[study.parameters[i]] = static_cast<int>(std::lround(likely[i]));
  const auto is_far = [](const auto& unit) { return std::abs(unit.second) > far; };
  if (std::abs(units.target) <= far && std::ranges::none_of(units.of, is_far)) return std::nullopt;
  return units;
}

Symbolic times_power_of_two(const Symbolic& e, int exponent) {
  return exponent == 0 ? e : Symbolic::integer_power(Symbolic::number("2"), exponent) * e;
}

ReadStudy in_units(ReadStudy study, const Units& units) {
  const auto substituted = [&](const Symbolic& formula) {
    return evaluate<Symbolic>(formula, [&](const std::string& name) {
      return times_power_of_two(Symbolic::variable(name), units.of.at(name));
    });
  };
  for (StudyAxis& axis : study.axes) {
    axis.lower = std::ldexp(axis.lower, -units.of.at(axis.variable));
    axis.upper = std::ldexp(axis.upper, -units.of.at(axis.variable));
    axis.density = substituted(axis.density);
  }
  study.target = times_power_of_two(substituted(study.target), -units.target);
  study.form = times_power_of_two(substituted(study.form), -units.target);
  study.weight = substituted(study.weight);
  return study;
}

/// A fit of that study as one of the study itself.
StudyFit in_own_units(const ReadStudy& study, const Units& units, StudyFit fit) {
  const int of_error = study.error == Error::relative ? 0 : units.target;
  const auto move = [&](std::vector<double>& values, const std::vector<std::string>& names) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::ldexp(values[i], units.of.at(names[i]));
  };
  const std::vector<std::string> variables = variables_of(study.axes);
  move(fit.parameters, study.parameters);
  // If the error is down to the rounding of 50 digits, a zero may be what they do not show.
  constexpr double rounding = 1e-36;
  for (std::size_t i = 0; i < fit.parameters.size() && fit.rms_error < rounding; ++i) {
    if (fit.parameters[i] == 0)
      fit.digits = std::min(fit.digits, correct_digits(std::ldexp(1e-47L, units.of.at(study.parameters[i]))));
  }
  if (fit.digits < least_study_digits) {
    fit.status = Status::not_converged;
    fit.why = "a parameter is beyond the digits of the target";
  }
  move(fit.other, study.parameters);
  move(fit.max_abs_error.at, variables);
  fit.max_abs_error.magnitude = std::ldexp(fit.max_abs_error.magnitude, units.target);
  fit.rms_error = std::ldexp(fit.rms_error, of_error);
  if (fit.level) fit.level = std::ldexp(*fit.level, of_error);
  for (StudyContact& contact : fit.touching) {
    move(contact.at, variables);
    contact.error = std::ldexp(contact.error, of_error);
  }
  for (AlternationPoint& point : fit.alternation) {
    point.at.cos_theta = std::ldexp(point.at.cos_theta, units.of.at(variables.front()));
    point.at.one_minus_cos = 1 - point.at.cos_theta;
    point.error = std::ldexp(point.error, of_error);
  }
  return fit;
}

}  // namespace

StudyFit solve_in_units(const ReadStudy& study, const std::vector<Held>& starts, const SolveStudy& solve) {
  const auto units = units_of_range(study);
  if (!units) return solve(study, starts);
  std::vector<Held> in_their_units = starts;
  for (Held& start : in_their_units) start.value = std::ldexp(start.value, -units->of.at(start.parameter));
  try {
    const StudyFit fit = solve(in_units(study, *units), in_their_units);
    if (fit.status == Status::converged) return in_own_units(study, *units, fit);
  } catch (const UserError&) {
    // The same fault in the study's own units has the numbers that its user knows.
  }
  return solve(study, starts);
}

}  // namespace shadefit
