#include "fit/verdicts/sensitivity.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "approx/scalar.hpp"
#include "fit/catalogue/near_peak.hpp"
#include "fit/squares/rules.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/root.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// Fitted constants and what they cost.
struct FittedConstants {
  std::vector<std::string> names;
  std::vector<double> values;
  /// The objective at other values.
  std::function<double(const std::vector<double>&)> objective;
  /// The least objective with constant i held at a value; NaN if that fit fails.
  std::function<double(std::size_t, double)> profile;
};

/// Enough to distinguish all doubles.
constexpr int digits_that_tell_apart = 17;

/// A value rounded to so many significant digits.
double rounded(double value, int digits) {
  return constant<double>(decimal(value, digits));
}

/// The decimals with so many significant digits below and above a value, the nearer one first.
std::array<double, 2> neighbours(double value, int digits) {
  if (value == 0) return {0, 0};
  const double nearest = rounded(value, digits);
  const double unit = std::pow(10.0, std::floor(std::log10(std::abs(value))) - digits + 1);
  return {nearest, rounded(nearest + (nearest > value ? -unit : unit), digits)};
}

/// The shortest decimal for one constant that keeps the objective below a limit.
std::string shortest(const FittedConstants& constants, std::size_t i, double limit) {
  std::vector<double> parameters = constants.values;
  const double value = parameters[i];
  for (int digits = 1; digits < digits_that_tell_apart; ++digits) {
    for (const double neighbour : neighbours(value, digits)) {
      parameters[i] = neighbour;
      if (constants.objective(parameters) <= limit) return to_text(neighbour);
    }
  }
  return to_text(value);
}

/// All constants, rounded to the fewest digits that keep the objective below a limit.
std::optional<CommonDigits> common(const FittedConstants& constants, double limit) {
  for (int digits = 1; digits <= digits_that_tell_apart; ++digits) {
    CommonDigits found{digits, {}, 0};
    std::vector<double> values = constants.values;
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = rounded(values[i], digits);
      found.parameters.push_back(to_text(values[i]));
    }
    found.objective = constants.objective(values);
    if (found.objective <= limit) return found;
  }
  return std::nullopt;
}

/// The place where the profile of the objective reaches a limit, in one direction from the fitted constant.
/// Empty if it does not within a hundred times the constant, or if a fit on the way fails.
std::optional<double> profile_end(const FittedConstants& constants, std::size_t i, double direction,
                                  double objective, double limit) {
  const double value = constants.values[i];
  const double scale = value != 0 ? std::abs(value) : 1;
  bool has_failed = false;
  const auto excess = [&](double step) {
    const double found = constants.profile(i, value + direction * step) - limit;
    if (std::isfinite(found)) return found;
    has_failed = true;
    return limit;  // any number above 0 ends the search
  };
  double inside = 0, excess_inside = objective - limit;
  double outside = 1e-4 * scale, excess_outside = excess(outside);
  while (excess_outside <= 0) {
    if (outside > 100 * scale) return std::nullopt;
    inside = outside;
    excess_inside = excess_outside;
    outside *= 2;
    excess_outside = excess(outside);
  }
  if (has_failed) return std::nullopt;
  if (excess_inside == 0) return value + direction * inside;
  // 30 bits of the step: an end is shown to six digits.
  const double step = root_between(excess, inside, outside, excess_inside, excess_outside, 30);
  return has_failed ? std::nullopt : std::optional(value + direction * step);
}

Sensitivity without_others(const FittedConstants& constants, const Checkpoint& checkpoint) {
  Sensitivity result{.objective = constants.objective(constants.values)};
  const double noticeable_limit = result.objective * (1 + noticeable),
               slight_limit = result.objective * (1 + slight);
  for (std::size_t i = 0; i < constants.values.size(); ++i) {
    checkpoint();
    result.parameters.push_back({constants.names[i], constants.values[i],
                                 shortest(constants, i, noticeable_limit),
                                 shortest(constants, i, slight_limit),
                                 profile_end(constants, i, -1, result.objective, noticeable_limit),
                                 profile_end(constants, i, 1, result.objective, noticeable_limit)});
  }
  result.noticeable_digits = common(constants, noticeable_limit);
  result.slight_digits = common(constants, slight_limit);
  return result;
}

void require_plain(const StudyObjective& objective) {
  if (objective.study.rows)
    throw UserError("--sensitivity does not go with --table: a fit of rows has profile intervals instead");
  if (objective.constraints != Constraints{})
    throw UserError("--sensitivity does not go with a constraint: rounded constants do not meet it");
  if (!objective.study.bounds.empty())
    throw UserError("--sensitivity does not go with --bounds: rounded constants do not keep to them");
}

FittedConstants constants_of(const StudyObjective& asked, const StudyFit& fit, const Checkpoint& checkpoint) {
  const ReadStudy study = read_study(near_peak(asked.study));
  FittedConstants constants{fit.names, fit.parameters, {}, {}};
  if (asked.norm == Norm::minimax) {
    constants.objective = [study](const std::vector<double>& parameters) {
      return largest_weighted_error(study, parameters).magnitude;
    };
  } else {
    constants.objective = [study, error = StudyError(study)](const std::vector<double>& parameters) {
      return rms_error(study, error, parameters);
    };
  }
  constants.profile = [asked, names = fit.names, objective = constants.objective, checkpoint](std::size_t i,
                                                                                              double value) {
    if (names.size() == 1) return objective({value});
    const StudyFit again = fit_study(holding(asked, names[i], value), checkpoint);
    // If the held constant alone causes the largest error, the others are free: any of them is the best.
    const bool is_answer = again.status == Status::converged ||
                           (asked.norm == Norm::minimax && again.status == Status::degenerate);
    if (!is_answer) return std::numeric_limits<double>::quiet_NaN();
    std::vector<double> all = again.parameters;
    all.insert(all.begin() + static_cast<std::ptrdiff_t>(i), value);
    return objective(all);
  };
  return constants;
}

/// The objectives that differ in the density or in the range.
std::vector<StudyObjective> others_of(const StudyObjective& asked) {
  std::vector<StudyObjective> others;
  const StudyAxis axis = read_study(asked.study).axes.front();
  if (asked.norm == Norm::least_squares && 0 <= axis.lower && axis.upper <= 1) {
    for (const char* word : {"angle", "cosine-weighted"}) {
      StudyObjective other = asked;
      other.study.over.front().density = density_of(word, axis.variable);
      other.words += std::string(", measure ") + word;
      others.push_back(other);
    }
  }
  const double tenth = (axis.upper - axis.lower) / 10;
  for (const auto& [lower, upper] : {std::pair{axis.lower + tenth, axis.upper},
                                     {axis.lower, axis.upper - tenth},
                                     {axis.lower + tenth, axis.upper - tenth}}) {
    StudyObjective other = asked;
    other.study.over.front().lower = to_text(lower);
    other.study.over.front().upper = to_text(upper);
    other.words += ", " + axis.variable + " in " + to_text(lower) + ":" + to_text(upper);
    others.push_back(other);
  }
  return others;
}

}  // namespace

Sensitivity sensitivity_of(const StudyObjective& objective, const StudyFit& fit,
                           const Checkpoint& checkpoint) {
  require_plain(objective);
  Sensitivity result = without_others(constants_of(objective, fit, checkpoint), checkpoint);
  if (objective.study.over.size() > 1) return result;
  result.others.push_back({objective.words, fit});
  for (const StudyObjective& other : others_of(objective)) {
    checkpoint();
    result.others.push_back({other.words, fit_study(other, checkpoint)});
  }
  return result;
}

}  // namespace shadefit
