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
  const Metric plain{.domain = metric.domain, .constraints = metric.constraints};
  if (fit.status == Status::converged) fit.max_abs_error = largest_error(setting, plain, fit.parameters);
  return fit;
}

}  // namespace shadefit
