#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "fit/catalogue/catalogue_study.hpp"
#include "fit/catalogue/family.hpp"
#include "fit/catalogue/fit_study.hpp"
#include "fit/exchange/constrained_study.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// The given values of a metric by the places of their parameters.
std::vector<std::optional<double>> given_parameters(const Family& family, const Constraints& constraints) {
  std::vector<std::optional<double>> given(family.parameters.size());
  for (const Held& held : constraints.held) given[parameter_index(family, held.parameter)] = held.value;
  return given;
}

/// Takes the fit of a study, whose free parameters are those without a given value.
void take(Fit& fit, const StudyFit& found, const std::vector<std::optional<double>>& given) {
  fit.status = found.status;
  fit.digits = found.digits;
  fit.level = found.level;
  fit.why = found.why;
  auto next = found.parameters.begin();
  for (std::size_t i = 0; i < given.size(); ++i)
    fit.parameters[i] = given[i] ? *given[i] : next != found.parameters.end() ? *next++ : 0;
  fit.alternation.assign(found.alternation.rbegin(), found.alternation.rend());  // from the peak down
}

void solve(Fit& fit) {
  const Family& family = *fit.family;
  const Setting setting = setting_of(fit);
  const Metric& metric = fit.metric;
  const auto ends = ends_of(family, setting, metric.domain, metric.error);
  if (!ends) {
    fit.status = Status::not_finite;
    fit.why = "a relative error has no meaning on this domain";
    return;
  }
  const StudyObjective asked{.study = study_of(family, setting, metric, *ends),
                             .norm = metric.norm,
                             .constraints = metric.constraints};
  StudyFit found;
  try {
    found = fit_constants(asked);
    fit.rms_error = found.rms_error / scale_of_weight(asked.study, metric.weight);
  } catch (const Infeasible& error) {
    fail(found, Status::infeasible, error.why);
  } catch (const UserError& error) {
    fail(found, Status::not_finite, error.what());
  }
  take(fit, found, given_parameters(family, metric.constraints));
}

/// What a relative error is relative to.
std::string denominator_of(const Family& family, const Surface& surface) {
  if (!family.is_fresnel) return "target >= 1/255";
  if (!surface.is_named())
    return "F = f0 + (1 - f0) f, f0 = " + (surface.f0 ? to_text(*surface.f0) : std::string(reference_f0));
  return surface.is_exact() ? "the exact F" : "Schlick's F, f0 of the surface";
}

}  // namespace

std::string contradiction_of(double rms_error, double largest_error) {
  constexpr double rounding = 1e-15;  // a few ulps at 1, the largest value of forms and targets
  if (!std::isfinite(largest_error)) return "the largest error is infinite";
  // Errors that differ by less count as equal in the search.
  if (rms_error <= largest_error * (1 + equal_extrema) + rounding) return "";
  return "the rms error " + to_text(rms_error) + " exceeds the largest error found, " +
         to_text(largest_error) + ": one of them is wrong";
}

std::vector<std::vector<Held>> Family::starts_of(const Setting& setting) const {
  const Surface& surface = setting.surface;
  const bool is_inside = surface.is_exact() && surface.ior < 1 && surface.extinction < surface.ior;
  const auto value_of = [&](const std::string& name) {
    return name == "k" ? setting.exponent : 1 / half_weight_cosine(surface);
  };
  std::vector<std::vector<Held>> points;
  for (const auto& start : is_inside && !starts_inside.empty() ? starts_inside : starts) {
    std::vector<Held>& point = points.emplace_back();
    for (const Symbolic& formula : start)
      point.push_back({parameters[point.size()], evaluate<double>(formula, value_of)});
  }
  return points;
}

Fit Family::fit(const Setting& setting, const Metric& metric) const {
  Fit result{.parameters = std::vector<double>(parameters.size()), .family = this, .metric = metric};
  if (has_exponent()) result.exponent = setting.exponent;
  if (is_fresnel) result.surface = setting.surface;
  solve(result);
  result.relative_to = denominator_of(*this, setting.surface);
  if (result.status != Status::converged) return result;
  add_errors(result);
  if (const auto defined = relative_domain(setting, metric.domain)) {
    result.relative_domain = *defined;
  } else {
    result.relative_to = "nothing: the target is nowhere between 1/255 and what a double can reach";
  }
  const bool is_relative = metric.error == Error::relative;
  result.why = contradiction_of(result.rms_error, is_relative ? result.max_rel_error.value().magnitude
                                                              : result.max_abs_error.magnitude);
  if (!result.why.empty()) result.status = Status::not_converged;
  return result;
}

}  // namespace shadefit
