#pragma once

#include <optional>
#include <string>
#include <string_view>

/// Doubles as text without a rounding: hexadecimal, "-0x1.62fp+2" for -5.5458984375.
namespace shadefit {

/// The double as C writes it by "%a", the same on every machine; finite numbers.
std::string hex_text(double value);

/// The double whose `hex_text` this is. Empty for anything else: a number that is not finite, more digits
/// than a double has, other spellings of the same double.
std::optional<double> parse_hex(std::string_view text);

}  // namespace shadefit
