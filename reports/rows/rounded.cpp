#include "reports/rows/rounded.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "fit/scalars/gpu_model.hpp"
#include "fit/support/hex_float.hpp"
#include "reports/rows/fit_json.hpp"

namespace shadefit {
namespace {

using Json = nlohmann::ordered_json;

/// The sets of a rounding, each with what it is.
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

Json set_json(const RoundedSets& of, const RoundedStudySet& set) {
  Json at = Json::object();
  for (std::size_t i = 0; i < set.at.size(); ++i) at[of.variables[i]] = set.at[i];
  return {{"parameters", json_object(of.parameters, set.values)},
          {"decimal", json_object(of.parameters, set.texts)},
          {"hex", json_object(of.parameters, set.values, hex_text)},
          {"max_error", set.max_error},
          {"at", at},
          {"real_error", optional_json(set.real_error)},
          {"rounding_error", optional_json(set.rounding_error)},
          {"srgb_codes", optional_json(set.srgb_codes)},
          {"gpu_bound", optional_json(set.gpu_bound)}};
}

/// The meaning of `max_error` of rounded constants.
std::string meaning_of_error(const RoundedStudy& rounded) {
  if (!rounded.best.real_error)
    return "every operation rounded, at every " + to_text(rounded.format) + " of the range";
  if (!rounded.best.rounding_error) return "proven, of the form in real numbers";
  return "a proven bound: of the form in real numbers, and of the rounding of each operation in float";
}

/// The meaning of "best", and by which error, if need be.
std::string meaning_of_best(const RoundedStudy& rounded) {
  const char* by = rounded.best.rounding_error ? " by their error in real numbers" : "";
  if (rounded.is_proven) return fmt::format("Best: proven, among {}{}.", rounded.searched, by);
  return fmt::format("Best found{}: of {} constants tried among {}, not proven.", by, rounded.evaluated,
                     rounded.searched);
}

}  // namespace

Cell at_most(double bound, int digits) {
  if (!(bound > 0) || !std::isfinite(bound)) return Number{bound, digits};
  const double unit = std::pow(10.0, std::floor(std::log10(bound)) - (digits - 1));
  return Number{std::ceil(bound / unit) * unit, digits};
}

Table roundings_table(const std::vector<RoundedSets>& all) {
  const RoundedSets& first = all.front();
  Table table;
  for (const auto& [constant, value] : first.given) table.columns.push_back(constant);
  table.columns.emplace_back("constants");
  for (const std::string& parameter : first.parameters) {
    table.columns.push_back(parameter);
    table.columns.push_back(parameter + " hex");
  }
  table.columns.push_back(first.error);
  for (const std::string& variable : first.variables) table.columns.push_back("at " + variable);
  std::vector<std::optional<double>> on_gpu, codes;
  for (const RoundedSets& of : all) {
    if (!of.rounded) continue;
    for (const auto& [what, set] : sets_of(*of.rounded)) {
      std::vector<Cell>& row = table.rows.emplace_back();
      for (const auto& [constant, value] : of.given) row.push_back(value);
      row.emplace_back(what);
      for (std::size_t k = 0; k < set->values.size(); ++k)
        row.insert(row.end(), {set->texts[k], hex_text(set->values[k])});
      row.push_back(at_most(set->max_error));
      for (std::size_t k = 0; k < of.variables.size(); ++k)
        row.push_back(set->at.empty() ? Cell() : Number{set->at[k], 6});
      on_gpu.push_back(set->gpu_bound);
      codes.push_back(set->srgb_codes);
    }
  }
  add_bounds(table, "on a GPU at most", on_gpu);
  add_bounds(table, "8-bit sRGB codes", codes);
  return table;
}

std::string roundings_text(const std::vector<RoundedSets>& all, const Terminal& terminal) {
  std::vector<std::string> said;
  for (const RoundedSets& of : all) {
    if (!of.rounded) {
      if (!of.reason.empty()) said.push_back(fmt::format("Not rounded: {}.", of.reason));
      continue;
    }
    const RoundedStudy& rounded = *of.rounded;
    said.push_back(fmt::format("Max error: {}.", meaning_of_error(rounded)));
    if (rounded.best.gpu_bound) said.push_back(fmt::format("On a GPU: {}.", gpu_assumption));
    said.push_back(meaning_of_best(rounded));
  }
  std::string text = "\n" + write_console(roundings_table(all), Precision::report, terminal);
  // A sentence that was said before is not said again.
  for (auto sentence = said.begin(); sentence != said.end(); ++sentence)
    if (std::find(said.begin(), sentence, *sentence) == sentence) text += *sentence + "\n";
  return text;
}

void add_rounding(Json& fit, const std::string& key, const RoundedSets& of) {
  Json& json = fit[key];
  if (!of.rounded) {
    fit[key + "_reason"] = of.reason;
    return;
  }
  const RoundedStudy& rounded = *of.rounded;
  json = {{"format", to_text(rounded.format)}};
  json.update(set_json(of, rounded.best));
  json["naive"] = set_json(of, rounded.naive);
  json["published"] = rounded.published ? set_json(of, *rounded.published) : Json();
  json["proven"] = rounded.is_proven;
  json["searched"] = rounded.searched;
  json["tried"] = rounded.evaluated;
  json["error_is"] = meaning_of_error(rounded);
  json["gpu_model"] = rounded.best.gpu_bound ? Json(gpu_assumption) : Json();
}

}  // namespace shadefit
