#include "reports/studies/study_extras.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "fit/scalars/gpu_model.hpp"
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

/// The sets of a study, each with what it is.
std::vector<std::pair<const char*, const RoundedStudySet*>> sets_of(const RoundedStudy& rounded) {
  std::vector<std::pair<const char*, const RoundedStudySet*>> sets{
      {rounded.is_proven ? "best" : "best found", &rounded.best}, {"fitted, rounded", &rounded.naive}};
  if (rounded.published) sets.emplace_back("published, rounded", &*rounded.published);
  return sets;
}

/// Appends a column of optional bounds; not one without any.
void add_bounds(Table& table, const std::string& column, const std::vector<std::optional<double>>& bounds) {
  if (std::ranges::none_of(bounds, [](const auto& bound) { return bound.has_value(); })) return;
  table.columns.push_back(column);
  for (std::size_t i = 0; i < bounds.size(); ++i)
    table.rows[i].push_back(bounds[i] ? at_most(*bounds[i]) : Cell());
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
  table.columns.push_back(error_name(first.asked()));
  for (const StudyRange& range : first.asked().over) table.columns.push_back("at " + range.variable);
  std::vector<std::optional<double>> on_gpu, codes;
  for (std::size_t i = 0; i < studies.size(); ++i) {
    if (!rounded[i]) continue;
    for (const auto& [what, set] : sets_of(*rounded[i])) {
      std::vector<Cell>& row = table.rows.emplace_back();
      for (const auto& [constant, value] : studies[i].asked().given) row.emplace_back(value);
      row.emplace_back(what);
      for (std::size_t k = 0; k < set->values.size(); ++k)
        row.insert(row.end(), {set->texts[k], hex_text(set->values[k])});
      row.push_back(at_most(set->max_error));
      for (std::size_t k = 0; k < first.asked().over.size(); ++k)
        row.push_back(set->at.empty() ? Cell() : Number{set->at[k], 6});
      on_gpu.push_back(set->gpu_bound);
      codes.push_back(set->srgb_codes);
    }
  }
  add_bounds(table, "on a GPU at most", on_gpu);
  add_bounds(table, "8-bit sRGB codes", codes);
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
    if (!one) continue;
    said.push_back(fmt::format("Max error: {}.", meaning_of_error(*one)));
    if (one->best.gpu_bound) said.push_back(fmt::format("On a GPU: {}.", gpu_assumption));
    said.push_back(meaning_of_best(*one, one->best.rounding_error ? " by their error in real numbers" : ""));
  }
  return "\n" + write_console(roundings_table(studies, rounded), Precision::report, terminal) +
         each_once(said);
}

Json study_rounding_json(const FittedStudy& study, const RoundedStudy& rounded) {
  const auto set_json = [&](const RoundedStudySet& set) {
    Json at = Json::object();
    for (std::size_t i = 0; i < set.at.size(); ++i) at[study.asked().over[i].variable] = set.at[i];
    return Json{{"parameters", json_object(study.fit.names, set.values)},
                {"decimal", json_object(study.fit.names, set.texts)},
                {"hex", json_object(study.fit.names, set.values, hex_text)},
                {"max_error", set.max_error},
                {"at", at},
                {"real_error", optional_json(set.real_error)},
                {"rounding_error", optional_json(set.rounding_error)},
                {"srgb_codes", optional_json(set.srgb_codes)},
                {"gpu_bound", optional_json(set.gpu_bound)}};
  };
  Json json{{"format", to_text(rounded.format)}};
  json.update(set_json(rounded.best));
  json["naive"] = set_json(rounded.naive);
  json["published"] = rounded.published ? set_json(*rounded.published) : Json();
  json["proven"] = rounded.is_proven;
  json["searched"] = rounded.searched;
  json["tried"] = rounded.evaluated;
  json["error_is"] = meaning_of_error(rounded);
  json["gpu_model"] = rounded.best.gpu_bound ? Json(gpu_assumption) : Json();
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
