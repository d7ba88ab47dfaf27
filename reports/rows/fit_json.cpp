#include "reports/rows/fit_json.hpp"

#include <algorithm>
#include <string>

#include "reports/rows/alternation.hpp"
#include "reports/rows/tables.hpp"

namespace shadefit {
namespace {

using Json = nlohmann::ordered_json;

Json domain_json(const Domain& domain) {
  return {domain.lower, domain.upper};
}

Json constraints_json(const Constraints& constraints) {
  Json fixed = Json::object();
  for (const Held& held : constraints.held) fixed[held.parameter] = held.value;
  return {{"fixed", fixed},
          {"exact_at", constraints.exact_at},
          {"one_sided", constraints.one_sided ? Json(name(*constraints.one_sided)) : Json()},
          {"at_most", optional_json(constraints.at_most)},
          {"at_least", optional_json(constraints.at_least)}};
}

/// `f0` of the relative error of a Fresnel form; null for others.
Json objective_json(const Metric& metric, const std::optional<double>& f0) {
  const bool is_minimax = metric.norm == Norm::minimax;
  return {{"measure", name(metric.measure)},
          {"measure_counts_for", is_minimax ? "rms_error alone: minimax has no measure" : "the fit"},
          {"norm", name(metric.norm)},
          {"error", name(metric.error)},
          {"f0", optional_json(f0)},
          {"weight", metric.weight.empty() ? "1" : metric.weight},
          {"constraints", constraints_json(metric.constraints)},
          {"domain", domain_json(metric.domain)}};
}

/// The places where the error is at its level or a constraint is active, from the peak down.
Json alternation_json(const Fit& fit) {
  return json_array(fit.alternation, [&](const AlternationPoint& point) -> Json {
    return {{"at", point.at.cos_theta},
            {"sign", sign_of_error(point, fit.metric.constraints)},
            {"error", point.error},
            {"holds", what_holds(point, fit.metric.constraints)},
            {"multiplier", point.multiplier}};
  });
}

Json range_json(const std::optional<ExponentRange>& range) {
  if (!range) return {};
  return {{"exactly", range->exactly}, {"from", range->from}, {"to", range->to}};
}

Json assessment_json(const Assessment& assessment) {
  const double printed = constant<double>(assessment.published->printed);
  return {{"id", assessment.published->id},
          {"parameter", assessment.published->parameter},
          {"printed", assessment.published->printed},
          {"deviation", assessment.computed - printed},
          {"verdict", name(assessment.judgement.verdict)},
          {"under", assessment.judgement.objective},
          {"holds_for", range_json(assessment.holds_for)}};
}

}  // namespace

Json write_fit_json(const Family& family, const FitReport& report) {
  const Fit& fit = report.fit;
  const bool is_answer = fit.status == Status::converged;
  const auto answer = [&](const Json& value) { return is_answer ? value : Json(); };

  const auto f0 = family.is_fresnel ? std::optional(normal_reflectance<double>(fit.surface)) : std::nullopt;

  Json published, verdict;
  Verdict worst = Verdict::confirmed;
  const auto parameter_of = [](const Assessment& a) { return a.published->parameter; };
  for (const std::string_view parameter : family.parameters) {
    // The fit is compared with the first number that was published for it.
    const auto first = std::ranges::find(report.assessments, parameter, parameter_of);
    if (first == report.assessments.end()) continue;
    published[std::string(parameter)] = constant<double>(first->published->printed);
    worst = std::max(worst, first->judgement.verdict);
    verdict = name(worst);
  }

  return {{"schema", fit_json_schema},
          {"constant", family.id},
          {"exponent", optional_json(fit.exponent)},
          {"parameters", json_object(family.parameters, fit.parameters, answer)},
          {"published", published},
          {"verdict", verdict},
          {"rms_error", answer(fit.rms_error)},
          {"max_abs_error", answer(fit.max_abs_error.magnitude)},
          {"max_abs_error_at", answer(fit.max_abs_error.at.cos_theta)},
          {"max_rel_error", fit.max_rel_error ? Json(fit.max_rel_error->magnitude) : Json()},
          {"max_rel_error_at", fit.max_rel_error ? Json(fit.max_rel_error->at.cos_theta) : Json()},
          {"relative_domain", fit.max_rel_error ? domain_json(fit.relative_domain) : Json()},
          {"relative_to", fit.relative_to},
          {"status", name(fit.status)},
          {"digits", answer(fit.digits)},
          {"objective", objective_json(fit.metric, f0)},
          {"level", fit.level ? answer(*fit.level) : Json()},
          {"alternation", fit.level ? answer(alternation_json(fit)) : Json()},
          {"why", fit.why.empty() ? Json() : Json(fit.why)},
          {"target", target_of(fit)},
          {"ior", fit.surface.is_named() ? Json(fit.surface.ior) : Json()},
          {"extinction", fit.surface.is_named() ? Json(fit.surface.extinction) : Json()},
          {"form", to_text(family.form)},
          {"assessments", json_array(report.assessments, assessment_json)}};
}

}  // namespace shadefit
