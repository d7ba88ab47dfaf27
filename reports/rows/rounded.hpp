#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "fit/rounding/rounding.hpp"
#include "fit/verdicts/refit.hpp"
#include "reports/table/table.hpp"

/// Rounded constants, as rows and as JSON.
namespace shadefit {

/// A bound with so many digits, rounded up, so that the printed number is a bound too.
Cell at_most(double bound, int digits = 6);

/// The rounded constants of a fit, or why there are none: the fit did not converge, or the format cannot hold
/// it.
struct RoundedFit {
  std::optional<Rounded> rounded = std::nullopt;
  std::string reason = {};
};

/// Rounds a fit, and the published values if each parameter has one. Throws UserError if the format cannot
/// hold them.
RoundedFit round_report(const FitReport& report, const NumberFormat& format, const Checkpoint& checkpoint);

/// Rounds every fit; `next` is called before each. `is_record`: the exponents are the record's own, and an
/// exponent that the format cannot hold is left out.
std::vector<RoundedFit> round_reports(const Refit& refit, const NumberFormat& format, bool is_record,
                                      const Checkpoint& next, const Checkpoint& checkpoint);

/// Rows of one table for the fits of a family: the best constants, the fit's own rounded, the published
/// rounded.
Table rounded_table(const Refit& refit, const std::vector<RoundedFit>& fits);

/// Lines for the console: the meaning of the table's errors, and the constants among which the best were
/// searched.
std::string rounded_text(const std::vector<RoundedFit>& fits);

/// Appends `rounded` to the JSON of a fit: null if there is none; then `rounded_reason` says why.
void add_rounded_json(nlohmann::ordered_json& fit_json, const FittableFamily& family, const RoundedFit& fit);

}  // namespace shadefit
