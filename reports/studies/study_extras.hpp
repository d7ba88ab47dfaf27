#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "fit/verdicts/sensitivity.hpp"
#include "reports/rows/rounded.hpp"
#include "reports/studies/study_rows.hpp"

/// What is computed for a fit of a study on request, as tables and as JSON: rounded constants, and the digits
/// of constants that matter.
namespace shadefit {

/// The constants of a fit as `round` rounds them, for their table and their JSON. A fit that did not converge
/// has none; of several fits, one that cannot be rounded has none either, and says why.
RoundedSets rounded_sets(const FittedStudy& study, bool is_one_of_several,
                         const std::function<RoundedStudy()>& round);

/// For a terminal: digits and intervals of each constant, all constants together, other objectives.
std::string sensitivity_text(const FittedStudy& study, const Sensitivity& sensitivity,
                             const Terminal& terminal);

/// The same as an object, for the `sensitivity` of a fit's JSON.
nlohmann::ordered_json sensitivity_json(const FittedStudy& study, const Sensitivity& sensitivity);

}  // namespace shadefit
