#include "fit/support/hex_float.hpp"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace shadefit {

// By hand: std::to_chars writes a subnormal as 0x0.0000000000001p-1022 in libstdc++ 12, and as 0x1p-1074
// in 14.
std::string hex_text(double value) {
  constexpr int fraction_bits = 52, bias = 1023, digits_of_fraction = fraction_bits / 4;
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << fraction_bits) - 1);
  const int exponent = static_cast<int>(bits >> fraction_bits & 0x7FF);
  std::string digits(digits_of_fraction, '0');
  for (std::size_t i = 0; i < digits.size(); ++i)
    digits[i] = "0123456789abcdef"[fraction >> (fraction_bits - 4 - 4 * i) & 0xF];
  digits.erase(digits.find_last_not_of('0') + 1);
  const int binary = exponent > 0 ? exponent - bias : fraction > 0 ? 1 - bias : 0;
  return std::string(std::signbit(value) ? "-" : "") + (exponent > 0 ? "0x1" : "0x0") +
         (digits.empty() ? "" : "." + digits) + (binary < 0 ? "p" : "p+") + std::to_string(binary);
}

std::optional<double> parse_hex(std::string_view text) {
  const bool is_negative = text.starts_with('-');
  const std::string_view magnitude = text.substr(is_negative ? 1 : 0);
  if (!magnitude.starts_with("0x")) return std::nullopt;
  const std::string_view digits = magnitude.substr(2);
  double value = 0;
  const char* end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value, std::chars_format::hex);
  if (error != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
  if (is_negative) value = -value;
  // A text with too many digits was rounded, and another spelling would be a second text for one number.
  return hex_text(value) == text ? std::optional(value) : std::nullopt;
}

}  // namespace shadefit
