#include "fit/catalogue/family.hpp"

#include <cmath>

#include "fit/catalogue/catalogue_study.hpp"
#include "fit/catalogue/fit_study.hpp"
#include "fit/catalogue/near_peak.hpp"
#include "fit/exchange/constrained_study.hpp"
#include "fit/formula/tape_program.hpp"
#include "fit/quadrature/substitution.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/study/study_nodes.hpp"
#include "fit/study/study_problem.hpp"
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

/// Where a change is looked for: densely at both ends of the domain, and near the peak of a lobe.
Substitution places_of(const Family& family, const Setting& setting, const Domain& domain) {
  const Shape shape = family.is_fresnel
                          ? Shape{}
                          : Shape{.concentration = 2 * setting.exponent, .end_power = setting.exponent};
  return {{.measure = Measure::cosine, .domain = domain}, shape};
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

Extremum Family::largest_error(const Setting& setting, Metric metric, std::span<const double> values) const {
  metric.measure = Measure::cosine;  // a density would bring edges of its own
  const Study asked = study_of(*this, setting, metric).value();
  const ReadStudy read = read_study(near_peak(asked));
  const PeakVariable variable = peak_variable(asked);
  const std::vector<double> at(values.begin(), values.end());
  if (const auto pole = pole_of(read, at)) return {HUGE_VAL, variable.cosine_at(*pole)};
  // The weighted error has no pole of its own, so the edges are those of the formulas.
  const StudyExtremum top = shadefit::largest_error(weighted_error_of(read), edges_of(read), at);
  return {top.magnitude, variable.cosine_at(top.at.front())};
}

Effect Family::effect(const Setting& setting, const Domain& domain, std::span<const double> from,
                      std::span<const double> to) const {
  const Study asked = study_of(*this, setting, {.domain = domain}).value();
  const PeakVariable variable = peak_variable(asked);
  ReadStudy changed = read_study(near_peak(asked));
  const Tape tape = tape_of(changed.form, formula_inputs(changed));
  TapeProgram<double> before(tape, from), after(tape, to);
  const auto of_cosine = [&](TapeProgram<double>& program) {
    return [&](const Cosine<double>& cosine) {
      const double at = variable.value_at(cosine);
      program.run(std::span(&at, 1));
      return program.output(0);
    };
  };
  Effect effect = sampled_effect(of_cosine(before), of_cosine(after), places_of(*this, setting, domain));
  changed.target = at_parameters(changed, changed.form, {from.begin(), from.end()});
  changed.form = at_parameters(changed, changed.form, {to.begin(), to.end()});
  changed.weight = Symbolic::number("1");
  changed.residual.reset();
  changed.parameters.clear();
  const StudyExtremum largest = shadefit::largest_error(changed, {});
  effect.absolute = {largest.magnitude, at_cosine(variable.cosine_at(largest.at.front()))};
  return effect;
}

}  // namespace shadefit
