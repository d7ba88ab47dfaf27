#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "fit/verdicts/sensitivity.hpp"
#include "reports/table/writers.hpp"

/// The digits of a fit's constants that matter, as tables and as JSON.
namespace shadefit {

/// The digits and intervals of each constant, and all constants together. `objective` is in words: "rms
/// error"; `setting` ends the headline: ", k = 5".
std::string digits_text(const std::string& objective, const std::string& setting,
                        const std::vector<std::string>& names, const Sensitivity& sensitivity,
                        const Terminal& terminal);

/// The same as an object.
nlohmann::ordered_json digits_json(const std::vector<std::string>& names, const Sensitivity& sensitivity);

/// For a terminal: digits and intervals of each constant, all constants together, other metrics.
std::string sensitivity_text(const Fit& fit, const Sensitivity& sensitivity, const Terminal& terminal = {});

/// The same as an object, for the `sensitivity` of a fit's JSON.
nlohmann::ordered_json sensitivity_json(const Fit& fit, const Sensitivity& sensitivity);

}  // namespace shadefit
