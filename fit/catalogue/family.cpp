#include "fit/catalogue/family.hpp"

#include <cmath>
#include <utility>

#include "fit/catalogue/fit_study.hpp"
#include "fit/catalogue/near_peak.hpp"
#include "fit/exchange/constrained_study.hpp"
#include "fit/formula/tape_program.hpp"
#include "fit/quadrature/substitution.hpp"
#include "fit/study/largest_error.hpp"
#include "fit/study/study_edges.hpp"
#include "fit/study/study_problem.hpp"
#include "fit/support/decimal.hpp"
#include "fit/support/hex_float.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// Fits the study of a family. A fit that fails says why.
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

Study fresnel_study(const Surface& surface, Error error) {
  const bool is_metal = surface.extinction > 0;
  Study study;
  study.target = !surface.is_exact() ? "(1 - c)^5"
                 : is_metal          ? "weight_of_reflectance(conductor_reflectance(c, n, k), f0)"
                                     : "weight_of_reflectance(dielectric_reflectance(c, n), f0)";
  if (surface.is_named() || error == Error::relative) {
    const std::string given = surface.f0 ? to_text(*surface.f0) : std::string(reference_f0);
    study.definitions = {{"f0",
                          {},
                          !surface.is_named() ? given
                          : is_metal          ? "conductor_reflectance_at_normal(n, k)"
                                              : "reflectance_at_normal(n)"}};
    study.weight =
        error == Error::relative ? "(1 - f0)/schlick_reflectance(f0, " + study.target + ")" : "1 - f0";
  }
  if (surface.is_named()) study.given["n"] = to_text(surface.ior);
  if (is_metal) study.given["k"] = to_text(surface.extinction);
  study.cuts.emplace();
  if (const auto cut = end_of_fall(surface)) study.cuts->push_back(*cut);
  return study;
}

std::optional<Study> study_of(const Family& family, const Setting& setting, const Metric& metric) {
  const auto [lower, upper] = metric.domain;
  Cosine<double> bottom{lower, 1 - lower};
  if (metric.error == Error::relative && !family.is_fresnel) {
    const auto visible_end = where_lobe_is_visible(setting.exponent);
    if (!visible_end) return std::nullopt;
    if (visible_end->cos_theta >= lower) bottom = *visible_end;
    if (bottom.one_minus_cos <= 1 - upper) return std::nullopt;
  }
  Study study = family.study;
  if (family.is_fresnel) {
    study = fresnel_study(setting.surface, metric.error);
    study.form = family.study.form;
  } else {
    study.given["k"] = hex_text(setting.exponent);
    study.error = metric.error;
  }
  study.over = {
      {"c", hex_text(bottom.cos_theta), hex_text(upper), density_of(std::string(name(metric.measure)), "c")}};
  study.held = metric.constraints.held;
  study.known_starts = family.starts_of(setting);
  if (metric.weight.empty()) return study;
  multiply_weight(study, metric.weight);
  return family.is_fresnel ? with_cuts(std::move(study)) : study;
}

void multiply_weight(Study& study, const std::string& weight) {
  if (weight.empty()) return;
  study.weight = study.weight == "1" ? weight : "(" + weight + ") (" + study.weight + ")";
}

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
  fit.why =
      contradiction_of(fit.rms_error, is_plain ? fit.max_abs_error.magnitude
                                               : largest_error(setting, metric, fit.parameters).magnitude);
  if (!fit.why.empty()) fit.status = Status::not_converged;
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
