#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "fit/verdicts/sensitivity.hpp"
#include "reports/table/writers.hpp"

/// How many digits of a fit's constants matter, in tables and as JSON.
namespace shadefit {

/// For a terminal: digits and intervals of each constant, all constants together, other contracts.
std::string sensitivity_text(const Fit& fit, const Sensitivity& sensitivity, const Terminal& terminal = {});

/// The same as an object, for the `sensitivity` of a fit's JSON.
nlohmann::ordered_json sensitivity_json(const Fit& fit, const Sensitivity& sensitivity);

}  // namespace shadefit
