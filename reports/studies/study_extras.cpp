#include "reports/studies/study_extras.hpp"

#include <fmt/format.h>

#include <functional>

#include "fit/support/hex_float.hpp"
#include "reports/rows/fit_json.hpp"
#include "reports/rows/rounded.hpp"
#include "reports/rows/sensitivities.hpp"

namespace shadefit {
namespace {

using Json = nlohmann::ordered_json;

std::string error_name(const Study& study) {
  return fmt::format("max {}{} error", study.weight == "1" ? "" : "weighted ",
                     study.error == Error::relative ? "rel" : "abs");
}

Table roundings_table(const std::vector<FittedStudy>& studies,
                      const std::vector<std::optional<RoundedStudy>>& rounded) {
  const FittedStudy& first = studies.front();
  Table table;
  for (const auto& [constant, value] : first.asked().given) table.columns.push_back(constant);
  table.columns.emplace_back("constants");
  for (const std::string& parameter : first.fit.names) {
    table.columns.push_back(parameter);
    table.columns.push_back(parameter + " hex");
  }
  table.columns.push_back(error_name(first.asked()) + " at most");
  for (const StudyRange& range : first.asked().over) table.columns.push_back("at " + range.variable);
  for (std::size_t i = 0; i < studies.size(); ++i) {
    if (!rounded[i]) continue;
    const auto add = [&](const char* what, const RoundedStudySet& set) {
      std::vector<Cell>& row = table.rows.emplace_back();
      for (const auto& [constant, value] : studies[i].asked().given) row.emplace_back(value);
      row.emplace_back(what);
      for (std::size_t k = 0; k < set.values.size(); ++k)
        row.insert(row.end(), {set.texts[k], hex_text(set.values[k])});
      row.push_back(at_most(set.max_error));
      for (const double place : set.at) row.emplace_back(Number{place, 6});
    };
    add(rounded[i]->is_proven ? "best" : "best found", rounded[i]->best);
    add("fitted, rounded", rounded[i]->naive);
  }
  return table;
}

std::string objective_name(const FittedStudy& study) {
  return std::string(study.fit.level ? "largest " : "rms ") +
         (study.asked().error == Error::relative ? "relative error" : "error") +
         (study.asked().weight == "1" ? "" : " times the weight");
}

}  // namespace

std::string study_roundings_text(const std::vector<FittedStudy>& studies,
                                 const std::vector<std::optional<RoundedStudy>>& rounded,
                                 const Terminal& terminal) {
  std::vector<std::string> said;
  for (const auto& one : rounded) {
    if (one) said.push_back(meaning_of_best(*one));
  }
  return "\n" + write_console(roundings_table(studies, rounded), Precision::report, terminal) +
         "Max error: proven, of the form in real numbers.\n" + each_once(said);
}

Json study_rounding_json(const FittedStudy& study, const RoundedStudy& rounded) {
  const auto set_json = [&](const RoundedStudySet& set) {
    Json at = Json::object();
    for (std::size_t i = 0; i < set.at.size(); ++i) at[study.asked().over[i].variable] = set.at[i];
    return Json{{"parameters", json_object(study.fit.names, set.values)},
                {"decimal", json_object(study.fit.names, set.texts)},
                {"hex", json_object(study.fit.names, set.values, hex_text)},
                {"max_error", set.max_error},
                {"at", at}};
  };
  Json json{{"format", to_text(rounded.format)}};
  json.update(set_json(rounded.best));
  json["naive"] = set_json(rounded.naive);
  json["proven"] = rounded.is_proven;
  json["searched"] = rounded.searched;
  json["tried"] = rounded.evaluated;
  return json;
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
