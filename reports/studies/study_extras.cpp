#include "reports/studies/study_extras.hpp"

#include <fmt/format.h>

#include <functional>

#include "reports/rows/fit_json.hpp"
#include "reports/rows/sensitivities.hpp"

namespace shadefit {
namespace {

using Json = nlohmann::ordered_json;

std::string error_name(const Study& study) {
  return fmt::format("max {}{} error", study.weight == "1" ? "" : "weighted ",
                     study.error == Error::relative ? "rel" : "abs");
}

std::string objective_name(const FittedStudy& study) {
  return std::string(study.fit.level ? "largest " : "rms ") +
         (study.asked().error == Error::relative ? "relative error" : "error") +
         (study.asked().weight == "1" ? "" : " times the weight");
}

}  // namespace

RoundedSets rounded_sets(const FittedStudy& study, const std::optional<RoundedStudy>& rounded) {
  RoundedSets sets{.rounded = rounded, .error = error_name(study.asked()), .parameters = study.fit.names};
  for (const StudyRange& range : study.asked().over) sets.variables.push_back(range.variable);
  for (const auto& [constant, value] : study.asked().given) sets.given.emplace_back(constant, value);
  return sets;
}

std::string study_sensitivity_text(const FittedStudy& study, const StudySensitivity& sensitivity,
                                   const Terminal& terminal) {
  const std::string given = given_text(study.asked());
  const std::string text = digits_text(objective_name(study), given.empty() ? "" : ", " + given,
                                       study.fit.names, sensitivity.constants, terminal);
  if (sensitivity.others.empty()) return text;
  return text + "\n" +
         write_console(other_fits_table(study.fit.names, sensitivity.others, std::identity()),
                       Precision::report, terminal);
}

Json study_sensitivity_json(const FittedStudy& study, const StudySensitivity& sensitivity) {
  Json json = digits_json(study.fit.names, sensitivity.constants);
  json["contracts"] = Json::array();
  for (const auto& [under, fit] : sensitivity.others)
    add_answer_json(json["contracts"].emplace_back(Json{{"under", under}}), study.fit.names, fit);
  return json;
}

}  // namespace shadefit
