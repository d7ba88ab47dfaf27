#include "fit/support/decimal.hpp"

#include <array>
#include <charconv>
#include <cmath>

#include "approx/scalar.hpp"

namespace shadefit {

std::optional<double> parse_number(std::string_view text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::string to_text(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::string decimal(double value, int digits) {
  if (value == 0) return "0";
  std::array<char, 64> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits);
  return {text.data(), end.ptr};
}

namespace {

/// At most one unit of the last of these digits.
double last_place(double value, int digits) {
  for (int i = 0; i < digits; ++i) value /= 10;
  return value;
}

}  // namespace

std::string decimal_above(double value, int digits) {
  const double step = last_place(value, digits);
  std::string text = decimal(value, digits);
  for (double more = value + step; constant<double>(text) < value; more += step) text = decimal(more, digits);
  return text;
}

std::string counted(long count, std::string_view noun) {
  return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

}  // namespace shadefit
