#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "fit/verdicts/sensitivity.hpp"
#include "reports/io/writers.hpp"
#include "reports/rows/fit_json.hpp"

/// The digits of a fit's constants that matter, as tables and as JSON.
namespace shadefit {

/// The digits and intervals of each constant, and all constants together. `objective` is in words: "rms
/// error"; `setting` ends the headline: ", k = 5".
std::string digits_text(const std::string& objective, const std::string& setting,
                        const std::vector<std::string>& names, const Sensitivity& sensitivity,
                        const Terminal& terminal);

/// The same as an object.
nlohmann::ordered_json digits_json(const std::vector<std::string>& names, const Sensitivity& sensitivity);

/// The same form under other objectives: pairs of an objective, of which `words` makes its name, and a fit.
template <class Others, class Words>
Table other_fits_table(const std::vector<std::string>& names, const Others& others, const Words& words) {
  Table table{{"the same form under"}};
  table.columns.insert(table.columns.end(), names.begin(), names.end());
  table.columns.insert(table.columns.end(), {"rms error", "max abs error", "status"});
  for (const auto& [objective, fit] : others) {
    const bool is_answer = fit.status == Status::converged;
    const auto cell = [&](const Number& value) { return is_answer ? Cell(value) : Cell(); };
    auto& row = table.rows.emplace_back(std::vector<Cell>{words(objective)});
    for (const double p : fit.parameters) row.push_back(cell(converged(p)));
    row.insert(row.end(), {cell(Number{fit.rms_error, 4}), cell(Number{fit.max_abs_error.magnitude, 4}),
                           std::string(name(fit.status))});
  }
  return table;
}

/// Appends the answer of such a fit: `status`, `parameters`, `rms_error` and `max_abs_error`.
template <class AnyFit>
void add_answer_json(nlohmann::ordered_json& json, const std::vector<std::string>& names, const AnyFit& fit) {
  const bool is_answer = fit.status == Status::converged;
  const auto answer = [&](const nlohmann::ordered_json& value) { return is_answer ? value : nullptr; };
  json["status"] = name(fit.status);
  json["parameters"] =
      json_object(names, is_answer ? fit.parameters : std::vector<double>(names.size()), answer);
  json["rms_error"] = answer(fit.rms_error);
  json["max_abs_error"] = answer(fit.max_abs_error.magnitude);
}

/// For a terminal: digits and intervals of each constant, all constants together, other metrics.
std::string sensitivity_text(const Fit& fit, const Sensitivity& sensitivity, const Terminal& terminal = {});

/// The same as an object, for the `sensitivity` of a fit's JSON.
nlohmann::ordered_json sensitivity_json(const Fit& fit, const Sensitivity& sensitivity);

}  // namespace shadefit
