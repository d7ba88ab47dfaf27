#pragma once

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "fit/better/fit_extras.hpp"
#include "reports/io/table.hpp"

/// Rounded constants, as rows and as JSON.
namespace shadefit {

/// A bound with so many digits, rounded up, so that the printed number is a bound too.
Cell at_most(double bound, int digits = 6);

/// The meaning of `max_error` of rounded constants.
std::string meaning_of_error(const RoundedStudy& rounded);

/// The meaning of "best", of the rounded constants of a fit or a study; `by` says by which error, if need be.
template <class AnyRounded>
std::string meaning_of_best(const AnyRounded& rounded, std::string_view by = "") {
  if (rounded.is_proven) return fmt::format("Best: proven, among {}{}.", rounded.searched, by);
  return fmt::format("Best found{}: of {} constants tried among {}, not proven.", by, rounded.evaluated,
                     rounded.searched);
}

/// A line for each sentence, without those that were said before.
std::string each_once(const std::vector<std::string>& sentences);

/// Rows of one table for the fits of a family: the best constants, the fit's own rounded, the published
/// rounded.
Table rounded_table(const Refit& refit, const std::vector<RoundedFit>& fits);

/// Lines for the console: the meaning of the table's errors, and the constants among which the best were
/// searched.
std::string rounded_text(const std::vector<RoundedFit>& fits, Error error);

/// Appends `rounded` to the JSON of a fit: null if there is none; then `rounded_reason` says why.
void add_rounded_json(nlohmann::ordered_json& fit_json, const Family& family, const RoundedFit& fit,
                      Error error);

}  // namespace shadefit
