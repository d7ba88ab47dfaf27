#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fit/ledger/finding.hpp"

/// Lists in the inputs of a record: "0.5, 1", "sRGB, gamma 2.2".
namespace shadefit {

/// The items between the separators, without the blanks around them. A text without a separator is one item.
inline std::vector<std::string> items_of(std::string_view text, char separator = ',') {
  std::vector<std::string> items;
  while (true) {
    const auto end = text.find(separator);
    std::string_view item = text.substr(0, end);
    while (item.starts_with(' ')) item.remove_prefix(1);
    while (item.ends_with(' ')) item.remove_suffix(1);
    items.emplace_back(item);
    if (end == std::string_view::npos) return items;
    text.remove_prefix(end + 1);
  }
}

/// The same as numbers. Throws std::invalid_argument if an item is not a number.
inline std::vector<double> numbers_of(std::string_view text, char separator = ',') {
  std::vector<double> numbers;
  for (const std::string& item : items_of(text, separator)) numbers.push_back(number_of(item));
  return numbers;
}

}  // namespace shadefit
