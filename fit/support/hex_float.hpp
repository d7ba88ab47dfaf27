#pragma once

#include <optional>
#include <string>
#include <string_view>

/// Doubles as text without rounding: hexadecimal, "-0x1.62fp+2" for -5.5458984375.
namespace shadefit {

/// A finite double as C's "%a", the same on every machine.
std::string hex_text(double value);

/// The double with this `hex_text`. Empty for anything else: a number that is not finite, too many digits,
/// another spelling of the same double.
std::optional<double> parse_hex(std::string_view text);

}  // namespace shadefit
