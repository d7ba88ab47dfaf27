#pragma once

#include <string_view>
#include <vector>

/// Sweeps of an exponent, as records and users write them.
namespace shadefit {

/// Numbers and ranges A:B:STEP, by commas: "1:15:1,25,50". A range includes B if a step ends within half a
/// step of it, and no number beyond B. Its numbers are rounded to 15 digits. Every number must be finite and
/// greater than 0, B at least A, and there may be at most 100 000 numbers. Throws UserError with one line
/// that names the part, its value and the rule.
std::vector<double> parse_sweep(std::string_view text);

}  // namespace shadefit
