#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "fit/rounding/rounded_set.hpp"
#include "fit/verdicts/sensitivity.hpp"
#include "reports/io/writers.hpp"
#include "reports/studies/study_rows.hpp"

/// What is computed for a fit of a study on request, as tables and as JSON: rounded constants, and the digits
/// of constants that matter.
namespace shadefit {

/// A bound with so many digits, rounded up, so that the printed number is a bound too.
Cell at_most(double bound, int digits = 6);

/// The constants of a fit in a number format.
struct RoundedFit {
  std::optional<RoundedStudy> rounded = {};
  std::string reason = {};  ///< why the fit could not be rounded
};

/// The constants of a fit as `round` rounds them. A fit that did not converge has none; of several fits, one
/// that cannot be rounded has none either, and says why.
RoundedFit rounded_fit(const FittedStudy& study, bool is_one_of_several,
                       const std::function<RoundedStudy()>& round);

/// For a terminal: the best constants of the format, the fitted and the published ones rounded, for each fit
/// that has them; the meaning of their errors, and the constants among which the best were searched.
std::string roundings_text(const std::vector<FittedStudy>& studies, const std::vector<RoundedFit>& all,
                           const Terminal& terminal);

/// Adds one of them to the JSON of its fit, as `rounded` or `evaluated`: an object, or null and the reason.
void add_rounding(nlohmann::ordered_json& fit, const std::string& key, const FittedStudy& study,
                  const RoundedFit& of);

/// For a terminal: digits and intervals of each constant, all constants together, other objectives.
std::string sensitivity_text(const FittedStudy& study, const Sensitivity& sensitivity,
                             const Terminal& terminal);

/// The same as an object, for the `sensitivity` of a fit's JSON.
nlohmann::ordered_json sensitivity_json(const FittedStudy& study, const Sensitivity& sensitivity);

}  // namespace shadefit
