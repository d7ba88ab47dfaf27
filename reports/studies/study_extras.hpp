#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "fit/rounding/rounded_set.hpp"
#include "fit/verdicts/study_sensitivity.hpp"
#include "reports/io/writers.hpp"
#include "reports/studies/study_rows.hpp"

/// What is computed for a fit of a study on request, as tables and as JSON: rounded constants, and the digits
/// of constants that matter.
namespace shadefit {

/// For a terminal: the best constants of the format and the fitted ones rounded, for each fit that has them;
/// the meaning of their errors, and the constants among which the best were searched.
std::string study_roundings_text(const std::vector<FittedStudy>& studies,
                                 const std::vector<std::optional<RoundedStudy>>& rounded,
                                 const Terminal& terminal);

/// One of them as an object, for the `rounded` or `evaluated` of a fit's JSON.
nlohmann::ordered_json study_rounding_json(const FittedStudy& study, const RoundedStudy& rounded);

/// For a terminal: digits and intervals of each constant, all constants together, other objectives.
std::string study_sensitivity_text(const FittedStudy& study, const StudySensitivity& sensitivity,
                                   const Terminal& terminal);

/// The same as an object, for the `sensitivity` of a fit's JSON.
nlohmann::ordered_json study_sensitivity_json(const FittedStudy& study, const StudySensitivity& sensitivity);

}  // namespace shadefit
