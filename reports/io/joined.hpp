#pragma once

#include <fmt/format.h>

#include <functional>
#include <iterator>
#include <string>
#include <string_view>

/// Lists as text.
namespace shadefit {

/// The texts of all elements, which `text` makes, with a separator between them.
template <class Range, class Text = std::identity>
std::string joined(const Range& range, std::string_view separator, const Text& text = {}) {
  std::string out;
  bool is_first = true;
  for (const auto& element : range) {
    if (!is_first) out += separator;
    out += std::invoke(text, element);
    is_first = false;
  }
  return out;
}

/// "a = 1, b = 2": names and values, of which `text` makes what is shown.
template <class Names, class Values, class Text = std::identity>
std::string equations(const Names& names, const Values& values, const Text& text = {}) {
  auto value = std::begin(values);
  return joined(names, ", ", [&](const auto& name) { return fmt::format("{} = {}", name, text(*value++)); });
}

/// The same of pairs of a name and a value.
template <class Pairs>
std::string equations(const Pairs& pairs) {
  return joined(pairs, ", ",
                [](const auto& pair) { return fmt::format("{} = {}", pair.first, pair.second); });
}

}  // namespace shadefit
