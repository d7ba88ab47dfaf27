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

/// The fit of the study of a family, or why there is none.
StudyFit solved(const Family& family, const Setting& setting, const Metric& metric) {
  StudyFit fit;
  try {
    if (const auto study = study_of(family, setting, metric))
      return fit_constants({.study = *study, .norm = metric.norm, .constraints = metric.constraints});
    fail(fit, Status::not_finite, "a relative error has no meaning on this domain");
  } catch (const Infeasible& error) {
    fail(fit, Status::infeasible, error.why);
  } catch (const UserError& error) {
    fail(fit, Status::not_finite, error.what());
  }
  return fit;
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
  const StudyFit found = solved(*this, setting, metric);
  Fit fit{.parameters = found.parameters,
          .status = found.status,
          .digits = found.digits,
          .rms_error = found.rms_error,
          .level = found.level,
          .alternation = found.alternation,
          .why = found.why,
          .family = this,
          .metric = metric};
  if (has_exponent()) fit.exponent = setting.exponent;
  if (is_fresnel) fit.surface = setting.surface;
  if (fit.status != Status::converged) return fit;
  const Metric plain{.domain = metric.domain, .constraints = metric.constraints};
  fit.max_abs_error = largest_error(setting, plain, fit.parameters);
  const bool is_plain = metric.error == Error::absolute && metric.weight.empty();
  fit.why = contradiction_of(
      fit.rms_error,
      (is_plain ? fit.max_abs_error : largest_error(setting, metric, fit.parameters)).magnitude);
  if (!fit.why.empty()) fit.status = Status::not_converged;
  return fit;
}

}  // namespace shadefit
