#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "fit/verdicts/study_sensitivity.hpp"
#include "reports/rows/rounded.hpp"
#include "reports/studies/study_rows.hpp"

/// What is computed for a fit of a study on request, as tables and as JSON: rounded constants, and the digits
/// of constants that matter.
namespace shadefit {

/// The rounded constants of a fit for their table and their JSON.
RoundedSets rounded_sets(const FittedStudy& study, const std::optional<RoundedStudy>& rounded);

/// For a terminal: digits and intervals of each constant, all constants together, other objectives.
std::string study_sensitivity_text(const FittedStudy& study, const StudySensitivity& sensitivity,
                                   const Terminal& terminal);

/// The same as an object, for the `sensitivity` of a fit's JSON.
nlohmann::ordered_json study_sensitivity_json(const FittedStudy& study, const StudySensitivity& sensitivity);

}  // namespace shadefit
