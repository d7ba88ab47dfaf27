#include "reports/studies/study_sensitivities.hpp"

#include <fmt/format.h>

#include "reports/rows/sensitivities.hpp"

namespace shadefit {
namespace {

using Json = nlohmann::ordered_json;

std::string objective_name(const FittedStudy& study) {
  return std::string(study.fit.level ? "largest " : "rms ") +
         (study.asked().error == Error::relative ? "relative error" : "error") +
         (study.asked().weight == "1" ? "" : " times the weight");
}

Table others_table(const FittedStudy& study, const StudySensitivity& sensitivity) {
  Table table{{"the same form under"}, {}};
  for (const std::string& parameter : study.fit.names) table.columns.push_back(parameter);
  for (const char* column : {"rms error", "max abs error", "status"}) table.columns.emplace_back(column);
  for (const auto& [under, fit] : sensitivity.others) {
    const bool is_answer = fit.status == Status::converged;
    const auto cell = [&](const Cell& value) { return is_answer ? value : Cell(); };
    std::vector<Cell> row{under};
    for (const double p : fit.parameters) row.push_back(cell(Number{p, 10}));
    row.insert(row.end(), {cell(Number{fit.rms_error, 4}), cell(Number{fit.max_abs_error.magnitude, 4}),
                           std::string(name(fit.status))});
    table.rows.push_back(row);
  }
  return table;
}

Json other_json(const FittedStudy& study, const OtherStudy& other) {
  const auto& [under, fit] = other;
  const bool is_answer = fit.status == Status::converged;
  Json parameters = Json::object();
  for (std::size_t i = 0; i < study.fit.names.size(); ++i)
    parameters[study.fit.names[i]] = is_answer ? Json(fit.parameters[i]) : Json();
  return {{"under", under},
          {"status", name(fit.status)},
          {"parameters", parameters},
          {"rms_error", is_answer ? Json(fit.rms_error) : Json()},
          {"max_abs_error", is_answer ? Json(fit.max_abs_error.magnitude) : Json()}};
}

}  // namespace

std::string study_sensitivity_text(const FittedStudy& study, const StudySensitivity& sensitivity,
                                   const Terminal& terminal) {
  const std::string given = given_text(study.asked());
  const std::string text = digits_text(objective_name(study), given.empty() ? "" : ", " + given,
                                       study.fit.names, sensitivity.constants, terminal);
  if (sensitivity.others.empty()) return text;
  return text + "\n" + write_console(others_table(study, sensitivity), Precision::report, terminal);
}

Json study_sensitivity_json(const FittedStudy& study, const StudySensitivity& sensitivity) {
  Json json = digits_json(study.fit.names, sensitivity.constants);
  Json others = Json::array();
  for (const OtherStudy& other : sensitivity.others) others.push_back(other_json(study, other));
  json["contracts"] = others;
  return json;
}

}  // namespace shadefit
