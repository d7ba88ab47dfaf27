#pragma once

#include <string>
#include <string_view>

/// Numbers in sentences: free of the locale, the same bytes on every compiler.
namespace shadefit {

/// `value` to that many significant digits, trailing zeros dropped: 0.775, 1.2e-05, -3, nan, inf. Negative
/// zero is 0.
std::string decimal(double value, int digits);

/// The least decimal of that many significant digits that is not below `value`, which is positive: for
/// bounds.
std::string decimal_above(double value, int digits);

/// The largest decimal of that many significant digits that is not above `value`, which is positive: for
/// bounds from below.
std::string decimal_below(double value, int digits);

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
