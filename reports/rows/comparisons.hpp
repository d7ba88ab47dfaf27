#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "fit/better/better.hpp"
#include "reports/io/table.hpp"

/// The published curves and the alternatives for a target, as rows and as JSON.
namespace shadefit {

/// "(1 - c)^5", "exact dielectric n = 1.5", "c^k at k = 5".
std::string target_of(const Comparison& comparison);

/// One row for each curve, for a terminal or a page. Errors have six digits, proven to one unit of the last.
Table comparison_table(const Comparison& comparison);

/// The same in short: four digits.
Table short_comparison_table(const Comparison& comparison);

/// One row per target and curve: better.csv. At Precision::full the largest error is the upper bound and
/// constants read back as they are; else as in `short_comparison_table`.
Table comparisons_table(const std::vector<Comparison>& comparisons, Precision precision);

/// One object for each target, with both bounds of each error.
nlohmann::ordered_json write_comparison_json(const Comparison& comparison);

/// A line for each curve whose bounds are wider than requested.
std::string not_reached_lines(const Comparison& comparison);

/// A line for each fit of a comparison without a row, because it did not converge.
std::string left_out_lines(const std::vector<std::string>& left_out);

}  // namespace shadefit
