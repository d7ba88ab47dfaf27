#pragma once

#include <optional>
#include <string>
#include <string_view>

/// Doubles as text without a rounding: hexadecimal, "-0x1.62fp+2" for -5.5458984375.
namespace shadefit {

/// The double as C writes it by "%a", the same on every machine; finite numbers.
std::string hex_text(double value);

/// The double of such a text, whole; empty for anything else, what is not finite too. Free of the locale.
std::optional<double> parse_hex(std::string_view text);

}  // namespace shadefit
