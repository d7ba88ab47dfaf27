#include "fit/verdicts/sensitivity.hpp"

#include <algorithm>
#include <array>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "approx/scalar.hpp"
#include "fit/support/decimal.hpp"

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

bool is_held(const Fit& fit, std::string_view parameter) {
  const auto& held = fit.metric.constraints.held;
  return std::any_of(held.begin(), held.end(), [&](const Held& h) { return h.parameter == parameter; });
}

/// The objective of a fit's problem at other constants.
class Objective {
 public:
  explicit Objective(const Fit& fit)
      : family_(*find_family(fit.family->id)),
        setting_(setting_of(fit)),
        metric_(fit.metric),
        at_optimum_(at(fit.parameters)) {}

  double at(const std::vector<double>& parameters) const {
    return family_.objective(setting_, metric_, parameters);
  }

  /// The least objective with one parameter held; NaN if that fit fails.
  double profile(std::size_t parameter, double value) const {
    if (family_.parameters.size() == 1) return at({value});
    Metric metric = metric_;
    metric.constraints.held.push_back({std::string(family_.parameters[parameter]), value});
    const auto held = static_cast<std::size_t>(metric.constraints.held.size());
    if (held == family_.parameters.size()) {
      std::vector<double> all(held);
      for (const Held& h : metric.constraints.held) all[parameter_index(family_, h.parameter)] = h.value;
      return at(all);
    }
    const Fit fit = family_.fit(setting_, metric);
    return fit.status == Status::converged ? at(fit.parameters) : std::numeric_limits<double>::quiet_NaN();
  }

  const FittableFamily& family() const { return family_; }
  double at_optimum() const { return at_optimum_; }

 private:
  const FittableFamily& family_;
  Setting setting_;
  Metric metric_;
  double at_optimum_;
};

/// The shortest decimal for one constant that keeps the objective below a limit.
std::string shortest(const Objective& objective, std::vector<double> parameters, std::size_t i,
                     double limit) {
  const double value = parameters[i];
  for (int digits = 1; digits < digits_that_tell_apart; ++digits) {
    for (const double neighbour : neighbours(value, digits)) {
      parameters[i] = neighbour;
      if (objective.at(parameters) <= limit) return to_text(neighbour);
    }
  }
  return to_text(value);
}

/// All constants that were fitted, rounded to the fewest digits that keep the objective below a limit. Given
/// constants stay.
std::optional<CommonDigits> common(const Objective& objective, const Fit& fit, double limit) {
  for (int digits = 1; digits <= digits_that_tell_apart; ++digits) {
    CommonDigits found{digits, {}, 0};
    std::vector<double> values = fit.parameters;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!is_held(fit, objective.family().parameters[i])) values[i] = rounded(values[i], digits);
      found.parameters.push_back(to_text(values[i]));
    }
    found.objective = objective.at(values);
    if (found.objective <= limit) return found;
  }
  return std::nullopt;
}

/// The place where the profile of the objective reaches a limit, in one direction from the fitted constant.
/// Empty if it does not within a hundred times the constant, or if a fit on the way fails.
std::optional<double> profile_end(const Objective& objective, std::size_t i, double value, double direction,
                                  double limit) {
  const double scale = value != 0 ? std::abs(value) : 1;
  bool has_failed = false;
  const auto excess = [&](double step) {
    const double found = objective.profile(i, value + direction * step) - limit;
    if (std::isfinite(found)) return found;
    has_failed = true;
    return limit;  // any number above 0 ends the search
  };
  double inside = 0, excess_inside = objective.at_optimum() - limit;
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
  std::uintmax_t steps = 60;
  const auto root = boost::math::tools::toms748_solve(excess, inside, outside, excess_inside, excess_outside,
                                                      boost::math::tools::eps_tolerance<double>(30), steps);
  if (has_failed) return std::nullopt;
  return value + direction * (root.first + root.second) / 2;
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

}  // namespace

Sensitivity sensitivity_of(const Fit& fit, const Checkpoint& checkpoint) {
  const Objective objective(fit);
  Sensitivity result{.objective = objective.at_optimum()};
  const double noticeable_limit = result.objective * (1 + noticeable),
               slight_limit = result.objective * (1 + slight);
  for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
    checkpoint();
    const double value = fit.parameters[i];
    const std::string_view name = objective.family().parameters[i];
    if (is_held(fit, name)) continue;  // a given constant has no sensitivity
    result.parameters.push_back({name, value, shortest(objective, fit.parameters, i, noticeable_limit),
                                 shortest(objective, fit.parameters, i, slight_limit),
                                 profile_end(objective, i, value, -1, noticeable_limit),
                                 profile_end(objective, i, value, 1, noticeable_limit)});
  }
  result.noticeable_digits = common(objective, fit, noticeable_limit);
  result.slight_digits = common(objective, fit, slight_limit);
  for (const Metric& metric : other_contracts(fit.metric)) {
    checkpoint();
    result.contracts.push_back({metric, objective.family().fit(setting_of(fit), metric)});
  }
  return result;
}

}  // namespace shadefit
