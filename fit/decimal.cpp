#include "fit/decimal.hpp"

#include <array>
#include <charconv>

#include "approx/scalar.hpp"

namespace shadefit {

std::string decimal(double value, int digits) {
  if (value == 0) return "0";
  std::array<char, 64> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits);
  return {text.data(), end.ptr};
}

std::string decimal_above(double value, int digits) {
  double step = value;  // no more than a unit of the last place
  for (int i = 0; i < digits; ++i) step /= 10;
  std::string text = decimal(value, digits);
  for (double more = value + step; constant<double>(text) < value; more += step) text = decimal(more, digits);
  return text;
}

std::string counted(long count, std::string_view noun) {
  return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

}  // namespace shadefit
