#include "fit/sweep.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include "fit/user_error.hpp"

namespace shadefit {
namespace {

constexpr double most_of_a_range = 100000;

[[noreturn]] void refuse(std::string_view part, const std::string& rule) {
  throw UserError("'" + std::string(part) + "' " + rule);
}

double positive(std::string_view part, std::string_view text) {
  const auto value = parse_number(text);
  if (!value) refuse(part, "is not a finite number");
  if (!(*value > 0)) refuse(part, "is not greater than 0");
  return *value;
}

void append_range(std::vector<double>& numbers, std::string_view part) {
  const auto first = part.find(':');
  const auto second = part.find(':', first + 1);
  if (second == std::string_view::npos || part.find(':', second + 1) != std::string_view::npos) {
    refuse(part, "is not a range A:B:STEP");
  }
  const double from = positive(part, part.substr(0, first));
  const double to = positive(part, part.substr(first + 1, second - first - 1));
  const double step = positive(part, part.substr(second + 1));
  if (to < from) refuse(part, "is a range that ends before it begins");
  const double count = std::floor((to - from) / step + 0.5) + 1;
  if (!(count <= most_of_a_range)) refuse(part, "is a range of more than 100000 numbers");
  for (int i = 0; i < static_cast<int>(count); ++i) numbers.push_back(from + i * step);
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::vector<double> parse_sweep(std::string_view text) {
  std::vector<double> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const auto end = std::min(text.find(',', begin), text.size());
    const auto part = text.substr(begin, end - begin);
    if (part.find(':') == std::string_view::npos) {
      numbers.push_back(positive(part, part));
    } else {
      append_range(numbers, part);
    }
    begin = end + 1;
  }
  return numbers;
}

}  // namespace shadefit
