#pragma once

#include <optional>
#include <string_view>
#include <vector>

/// Sweeps of an exponent, as records and users write them.
namespace shadefit {

/// A finite number written in plain or scientific decimal notation, whole text; empty for anything else:
/// text, NaN, infinities, numbers beyond double. Free of the locale.
std::optional<double> parse_number(std::string_view text);

/// Numbers and ranges A:B:STEP, by commas: "1:15:1,25,50". A range includes B where a step ends within half a
/// step of it, and no number beyond B; its numbers are rounded to 15 digits. Every number has to be finite
/// and greater than 0, B at least A, and all of them together at most 100 000. Throws UserError with one line
/// that names the part, its value and the rule.
std::vector<double> parse_sweep(std::string_view text);

}  // namespace shadefit
