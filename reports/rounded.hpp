#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "fit/refit.hpp"
#include "fit/rounding.hpp"
#include "reports/table.hpp"

/// Rounded constants, as rows and as JSON.
namespace shadefit {

/// Rounds a fit and, where each of its parameters has one, the published values. Empty where the fit did not
/// converge.
std::optional<Rounded> round_report(const FitReport& report, const NumberFormat& format,
                                    const Checkpoint& checkpoint);

/// Rows of one table for the fits of a family: the best constants, the fit's own rounded, the published
/// rounded.
Table rounded_table(const Refit& refit, const std::vector<std::optional<Rounded>>& rounded);

/// What the table's errors are, and among which constants the best were looked for: lines for the console.
std::string rounded_text(const std::vector<std::optional<Rounded>>& rounded);

/// Appends `rounded` to the JSON of a fit: null where there is none.
void add_rounded_json(nlohmann::ordered_json& fit_json, const FittableFamily& family,
                      const std::optional<Rounded>& rounded);

}  // namespace shadefit
