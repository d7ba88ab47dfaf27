#include "fit/decimal.hpp"

#include <array>
#include <charconv>

namespace shadefit {

std::string decimal(double value, int digits) {
  if (value == 0) return "0";
  std::array<char, 64> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits);
  return {text.data(), end.ptr};
}

std::string counted(long count, std::string_view noun) {
  return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

}  // namespace shadefit
