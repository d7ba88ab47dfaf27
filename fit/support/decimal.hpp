#pragma once

#include <optional>
#include <string>
#include <string_view>

/// Numbers as text: free of the locale, the same bytes on every compiler.
namespace shadefit {

/// A finite number in plain or scientific decimal notation. Empty if the whole text is not such a number, or
/// the number is beyond double.
std::optional<double> parse_number(std::string_view text);

/// The shortest text that reads back as `value`.
std::string to_text(double value);

/// `value` with that many significant digits, without trailing zeros: 0.775, 1.2e-05, -3, nan, inf. Negative
/// zero is 0.
std::string decimal(double value, int digits);

/// The least decimal with that many significant digits that is not below the positive `value`: for upper
/// bounds.
std::string decimal_above(double value, int digits);

/// "1 fit", "2 fits".
std::string counted(long count, std::string_view noun);

/// "a, b and c".
template <class Strings>
std::string enumerated(const Strings& words) {
  std::string out;
  std::size_t i = 0;
  for (const auto& word : words) {
    if (i > 0) out += i + 1 == words.size() ? " and " : ", ";
    out += word;
    ++i;
  }
  return out;
}

}  // namespace shadefit
