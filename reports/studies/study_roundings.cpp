#include "reports/studies/study_roundings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "fit/support/hex_float.hpp"
#include "reports/rows/rounded.hpp"

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
      std::vector<Cell> row;
      for (const auto& [constant, value] : studies[i].asked().given) row.emplace_back(value);
      row.emplace_back(what);
      for (std::size_t k = 0; k < set.values.size(); ++k)
        row.insert(row.end(), {set.texts[k], hex_text(set.values[k])});
      row.push_back(at_most(set.max_error));
      for (const double place : set.at) row.emplace_back(Number{place, 6});
      table.rows.push_back(row);
    };
    add(rounded[i]->is_proven ? "best" : "best found", rounded[i]->best);
    add("fitted, rounded", rounded[i]->naive);
  }
  return table;
}

}  // namespace

std::string study_roundings_text(const std::vector<FittedStudy>& studies,
                                 const std::vector<std::optional<RoundedStudy>>& rounded,
                                 const Terminal& terminal) {
  std::string text = "\n" + write_console(roundings_table(studies, rounded), Precision::report, terminal) +
                     "Max error: proven, of the form in real numbers.\n";
  std::vector<std::string> said;  // each sentence once
  for (const auto& one : rounded) {
    if (!one) continue;
    const std::string sentence =
        one->is_proven ? fmt::format("Best: proven, among {}.\n", one->searched)
                       : fmt::format("Best found: of {} constants tried among {}, not proven.\n",
                                     one->evaluated, one->searched);
    if (std::find(said.begin(), said.end(), sentence) != said.end()) continue;
    said.push_back(sentence);
    text += sentence;
  }
  return text;
}

Json study_rounding_json(const FittedStudy& study, const RoundedStudy& rounded) {
  const auto set_json = [&](const RoundedStudySet& set) {
    Json parameters = Json::object(), decimals = Json::object(), hexes = Json::object(), at = Json::object();
    for (std::size_t i = 0; i < set.values.size(); ++i) {
      const std::string& parameter = study.fit.names[i];
      parameters[parameter] = set.values[i];
      decimals[parameter] = set.texts[i];
      hexes[parameter] = hex_text(set.values[i]);
    }
    for (std::size_t i = 0; i < set.at.size(); ++i) at[study.asked().over[i].variable] = set.at[i];
    return Json{{"parameters", parameters},
                {"decimal", decimals},
                {"hex", hexes},
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

}  // namespace shadefit
