#pragma once

#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "reports/io/escape.hpp"

/// Fits as JSON. Every number is the shortest decimal that reads back.
namespace shadefit {

/// The version of the objects below; it grows when a field changes its meaning, not when one is added.
inline constexpr int fit_json_schema = 1;

/// The value, or null.
template <class T>
nlohmann::ordered_json optional_json(const std::optional<T>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
}

/// An object with these names and, of each, the value that `of` makes.
template <class Names, class Values, class Of = std::identity>
nlohmann::ordered_json json_object(const Names& names, const Values& values, const Of& of = {}) {
  auto object = nlohmann::ordered_json::object();
  auto value = std::begin(values);
  for (const auto& name : names) object[std::string(name)] = of(*value++);
  return object;
}

/// The same of pairs of a name and a value.
template <class Pairs>
nlohmann::ordered_json json_object(const Pairs& pairs) {
  auto object = nlohmann::ordered_json::object();
  for (const auto& [name, value] : pairs) object[name] = value;
  return object;
}

/// An array of what `of` makes of each element.
template <class Range, class Of>
nlohmann::ordered_json json_array(const Range& range, const Of& of) {
  auto array = nlohmann::ordered_json::array();
  for (const auto& element : range) array.push_back(of(element));
  return array;
}

/// An array for a sweep, the object itself for one.
inline std::string json_text_of_each(const nlohmann::ordered_json& array) {
  return json_text(array.size() == 1 ? array.front() : array);
}

}  // namespace shadefit
