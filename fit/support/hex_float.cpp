#include "fit/support/hex_float.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace shadefit {

std::string hex_text(double value) {
  std::array<char, 64> digits{};
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), std::abs(value), std::chars_format::hex);
  return (std::signbit(value) ? "-0x" : "0x") + std::string(digits.data(), end.ptr);
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
