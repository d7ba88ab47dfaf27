#include "reports/fit_json.hpp"

#include <algorithm>
#include <string>

#include "reports/tables.hpp"

namespace shadefit {
namespace {

using Json = nlohmann::ordered_json;

Json domain_json(const Domain& domain) {
  return {domain.lower, domain.upper};
}

Json objective_json(const Metric& metric) {
  return {{"measure", name(metric.measure)},
          {"norm", name(metric.norm)},
          {"error", name(metric.error)},
          {"domain", domain_json(metric.domain)}};
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

/// The numbers that fits of a family are judged by: the first published for each parameter.
std::vector<const Assessment*> principal(const FittableFamily& family, const FitReport& report) {
  std::vector<const Assessment*> found;
  for (const std::string_view parameter : family.parameters) {
    const auto first = std::find_if(report.assessments.begin(), report.assessments.end(),
                                    [&](const Assessment& a) { return a.published->parameter == parameter; });
    if (first != report.assessments.end()) found.push_back(&*first);
  }
  return found;
}

}  // namespace

Json write_fit_json(const FittableFamily& family, const FitReport& report) {
  const Fit& fit = report.fit;
  const bool is_answer = fit.status == Status::converged;
  const auto answer = [&](const Json& value) { return is_answer ? value : Json(); };

  Json parameters, published;
  for (std::size_t i = 0; i < family.parameters.size(); ++i)
    parameters[std::string(family.parameters[i])] = answer(fit.parameters[i]);
  Json verdict;
  Verdict worst = Verdict::confirmed;
  for (const Assessment* a : principal(family, report)) {
    published[std::string(a->published->parameter)] = constant<double>(a->published->printed);
    worst = std::max(worst, a->judgement.verdict);
    verdict = name(worst);
  }
  Json assessments = Json::array();
  for (const Assessment& a : report.assessments) assessments.push_back(assessment_json(a));

  return {{"schema", fit_json_schema},
          {"constant", family.info.id},
          {"exponent", fit.exponent ? Json(*fit.exponent) : Json()},
          {"parameters", parameters},
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
          {"iterations", fit.iterations},
          {"digits", fit.digits},
          {"objective", objective_json(fit.metric)},
          {"target", target_of(fit)},
          {"ior", fit.surface.is_named() ? Json(fit.surface.ior) : Json()},
          {"extinction", fit.surface.is_named() ? Json(fit.surface.extinction) : Json()},
          {"form", to_text(family.form())},
          {"assessments", assessments}};
}

Json write_derived_json(const Assessment& a) {
  const std::string parameter(a.published->parameter);
  return {{"schema", fit_json_schema},
          {"constant", a.published->id},
          {"exponent", nullptr},
          {"parameters", {{parameter, a.computed}}},
          {"published", {{parameter, constant<double>(a.published->printed)}}},
          {"verdict", name(a.judgement.verdict)},
          {"rms_error", nullptr},
          {"max_abs_error", nullptr},
          {"max_abs_error_at", nullptr},
          {"max_rel_error", nullptr},
          {"max_rel_error_at", nullptr},
          {"relative_domain", nullptr},
          {"relative_to", "a mean or limit of fits has no curve of its own"},
          {"status", name(Status::converged)},
          {"iterations", nullptr},
          {"digits", nullptr},
          {"objective", objective_json(a.metric)},
          {"assessments", Json::array({assessment_json(a)})}};
}

}  // namespace shadefit
