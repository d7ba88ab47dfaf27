#include "fit/verdicts/sensitivity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "approx/scalar.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/root.hpp"

namespace shadefit {
namespace {

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

/// All constants that were fitted, rounded to the fewest digits that keep the objective below a limit. Given
/// constants stay.
std::optional<CommonDigits> common(const FittedConstants& constants, double limit) {
  for (int digits = 1; digits <= digits_that_tell_apart; ++digits) {
    CommonDigits found{digits, {}, 0};
    std::vector<double> values = constants.values;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!constants.is_given[i]) values[i] = rounded(values[i], digits);
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

std::vector<Metric> other_contracts(const Metric& own) {
  std::vector<Metric> contracts{own};
  if (own.norm == Norm::least_squares) {
    for (const Measure measure : measures) {
      Metric other = own;
      other.measure = measure;
      if (other != own) contracts.push_back(other);
    }
  }
  const double tenth = (own.domain.upper - own.domain.lower) / 10;
  const Domain without_horizon{own.domain.lower + tenth, own.domain.upper},
      without_peak{own.domain.lower, own.domain.upper - tenth},
      without_either{own.domain.lower + tenth, own.domain.upper - tenth};
  for (const Domain& domain : {without_horizon, without_peak, without_either}) {
    Metric other = own;
    other.domain = domain;
    contracts.push_back(other);
  }
  return contracts;
}

/// The constants of a fit of a family. `fit` must outlive them.
FittedConstants constants_of(const Fit& fit) {
  const Family& family = *fit.family;
  const Setting setting = setting_of(fit);
  FittedConstants constants{{family.parameters.begin(), family.parameters.end()}, fit.parameters, {}, {}, {}};
  const std::vector<Held>& given = fit.metric.constraints.held;
  for (const std::string& name : constants.names)
    constants.is_given.push_back(
        std::ranges::any_of(given, [&](const Held& h) { return h.parameter == name; }));
  const Objective objective = family.objective(setting, fit.metric);
  constants.objective = objective;
  constants.profile = [&family, setting, &fit, objective](std::size_t i, double value) {
    if (family.parameters.size() == 1) return objective(std::span(&value, 1));
    Metric metric = fit.metric;
    std::vector<Held>& held = metric.constraints.held;
    held.push_back({std::string(family.parameters[i]), value});
    if (held.size() == family.parameters.size()) {
      std::vector<double> all(held.size());
      for (const Held& h : held) all[parameter_index(family, h.parameter)] = h.value;
      return objective(all);
    }
    const Fit again = family.fit(setting, metric);
    return again.status == Status::converged ? objective(again.parameters)
                                             : std::numeric_limits<double>::quiet_NaN();
  };
  return constants;
}

}  // namespace

Sensitivity sensitivity_of(const FittedConstants& constants, const Checkpoint& checkpoint) {
  Sensitivity result{.objective = constants.objective(constants.values)};
  const double noticeable_limit = result.objective * (1 + noticeable),
               slight_limit = result.objective * (1 + slight);
  for (std::size_t i = 0; i < constants.values.size(); ++i) {
    checkpoint();
    if (constants.is_given[i]) continue;  // it has no sensitivity
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

Sensitivity sensitivity_of(const Fit& fit, const Checkpoint& checkpoint) {
  Sensitivity result = sensitivity_of(constants_of(fit), checkpoint);
  for (const Metric& metric : other_contracts(fit.metric)) {
    checkpoint();
    result.contracts.push_back({metric, fit.family->fit(setting_of(fit), metric)});
  }
  return result;
}

}  // namespace shadefit
