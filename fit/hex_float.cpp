#include "fit/hex_float.hpp"

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
  if (is_negative) text.remove_prefix(1);
  if (!text.starts_with("0x")) return std::nullopt;
  text.remove_prefix(2);
  if (text.empty() || text.starts_with('-')) return std::nullopt;
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value, std::chars_format::hex);
  if (error != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
  return is_negative ? -value : value;
}

}  // namespace shadefit
