#include "fit/support/sweep.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include "fit/support/decimal.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

constexpr std::size_t most_numbers = 100000;

[[noreturn]] void refuse(std::string_view part, const std::string& rule) {
  throw UserError("'" + std::string(part) + "' " + rule);
}

double positive(std::string_view text, const std::string& of = "") {
  double value = 0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), value);
  if (parsed.ec == std::errc::result_out_of_range) refuse(text, of + "is beyond the range of a double");
  if (!parse_number(text)) refuse(text, of + "is not a finite number");
  if (!(value > 0)) refuse(text, of + "is not greater than 0");
  return value;
}

/// The number rounded to 15 digits, so that 0.1 + 2 * 0.1 is 0.3.
double without_rounding(double x) {
  return *parse_number(decimal(x, 15));
}

void append_range(std::vector<double>& numbers, std::string_view part) {
  const auto first = part.find(':');
  const auto second = part.find(':', first + 1);
  if (second == std::string_view::npos || part.find(':', second + 1) != std::string_view::npos) {
    refuse(part, "is not a range A:B:STEP");
  }
  const std::string of = "in '" + std::string(part) + "' ";
  const double from = positive(part.substr(0, first), of);
  const double to = positive(part.substr(first + 1, second - first - 1), of);
  const double step = positive(part.substr(second + 1), of);
  if (to < from) refuse(part, "is a range that ends before it begins");
  const double count = std::floor((to - from) / step + 0.5) + 1;
  if (!(count <= static_cast<double>(most_numbers))) refuse(part, "is a range of more than 100000 numbers");
  for (int i = 0; i < static_cast<int>(count); ++i) {
    numbers.push_back(std::min(without_rounding(std::min(from + i * step, to)), to));
  }
}

}  // namespace

std::vector<double> parse_sweep(std::string_view text) {
  std::vector<double> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const auto end = std::min(text.find(',', begin), text.size());
    const auto part = text.substr(begin, end - begin);
    if (part.find(':') == std::string_view::npos) {
      numbers.push_back(positive(part));
    } else {
      append_range(numbers, part);
    }
    if (numbers.size() > most_numbers) refuse(text, "holds more than 100000 numbers");
    begin = end + 1;
  }
  return numbers;
}

}  // namespace shadefit
