#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "fit/verdicts/study_sensitivity.hpp"
#include "reports/studies/study_rows.hpp"
#include "reports/table/writers.hpp"

/// The digits of a study's constants that matter, as tables and as JSON.
namespace shadefit {

/// For a terminal: digits and intervals of each constant, all constants together, other objectives.
std::string study_sensitivity_text(const FittedStudy& study, const StudySensitivity& sensitivity,
                                   const Terminal& terminal);

/// The same as an object, for the `sensitivity` of a fit's JSON.
nlohmann::ordered_json study_sensitivity_json(const FittedStudy& study, const StudySensitivity& sensitivity);

}  // namespace shadefit
