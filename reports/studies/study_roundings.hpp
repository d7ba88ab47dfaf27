#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "fit/rounding/round_study.hpp"
#include "reports/studies/study_rows.hpp"
#include "reports/table/writers.hpp"

/// Rounded constants of studies, as rows and as JSON.
namespace shadefit {

/// For a terminal: the best constants of the format and the fitted ones rounded, for each fit that has them;
/// the meaning of their errors, and the constants among which the best were searched.
std::string study_roundings_text(const std::vector<FittedStudy>& studies,
                                 const std::vector<std::optional<RoundedStudy>>& rounded,
                                 const Terminal& terminal);

/// One of them as an object, for the `rounded` of a fit's JSON.
nlohmann::ordered_json study_rounding_json(const FittedStudy& study, const RoundedStudy& rounded);

}  // namespace shadefit
