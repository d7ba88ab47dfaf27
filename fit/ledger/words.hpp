#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

/// Lists inside a record.
namespace shadefit {

/// The words between spaces and commas: "half, float" is half and float.
inline std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  constexpr std::string_view between = " ,";
  for (auto begin = text.find_first_not_of(between); begin != std::string_view::npos;) {
    const auto end = std::min(text.find_first_of(between, begin), text.size());
    words.emplace_back(text.substr(begin, end - begin));
    begin = text.find_first_not_of(between, end);
  }
  return words;
}

}  // namespace shadefit
