#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "fit/run/fit_extras.hpp"
#include "reports/table/table.hpp"

/// Rounded constants, as rows and as JSON.
namespace shadefit {

/// A bound with so many digits, rounded up, so that the printed number is a bound too.
Cell at_most(double bound, int digits = 6);

/// Rows of one table for the fits of a family: the best constants, the fit's own rounded, the published
/// rounded.
Table rounded_table(const Refit& refit, const std::vector<RoundedFit>& fits);

/// Lines for the console: the meaning of the table's errors, and the constants among which the best were
/// searched.
std::string rounded_text(const std::vector<RoundedFit>& fits);

/// Appends `rounded` to the JSON of a fit: null if there is none; then `rounded_reason` says why.
void add_rounded_json(nlohmann::ordered_json& fit_json, const FittableFamily& family, const RoundedFit& fit);

}  // namespace shadefit
