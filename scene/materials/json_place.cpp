#include "scene/materials/json_place.hpp"

#include <fmt/format.h>

#include <cmath>

#include "fit/support/user_error.hpp"
#include "scene/materials/messages.hpp"

namespace shadefit::scene {
std::string words_of(const JsonPlace& place) {
  return fmt::format("'{}': {}", place.file, place.pointer.empty() ? "/" : place.pointer);
}

void refuse(const JsonPlace& place, std::string_view rule) {
  const nlohmann::json& value = *place.value;
  std::string shown;
  if (value.is_string()) {
    shown = " = " + nlohmann::json(shortened(value.get_ref<const std::string&>())).dump();
  } else if (value.is_primitive()) {
    shown = " = " + value.dump();
  }
  throw UserError(fmt::format("{}{}: {}", words_of(place), shown, rule));
}

std::optional<JsonPlace> member(const JsonPlace& object, std::string_view key) {
  if (!object.value->is_object()) refuse(object, "it must be an object");
  const auto found = object.value->find(key);
  if (found == object.value->end()) return std::nullopt;
  return JsonPlace{&*found, fmt::format("{}/{}", object.pointer, key), object.file};
}

JsonPlace member_or_empty(const JsonPlace& object, std::string_view key) {
  static const nlohmann::json empty = nlohmann::json::object();
  return member(object, key)
      .value_or(JsonPlace{&empty, fmt::format("{}/{}", object.pointer, key), object.file});
}

JsonPlace required_member(const JsonPlace& object, std::string_view key) {
  const auto found = member(object, key);
  if (!found) refuse(object, fmt::format("its member '{}' is missing", key));
  return *found;
}

std::optional<JsonPlace> extension(const JsonPlace& object, std::string_view name) {
  const auto extensions = member(object, "extensions");
  return extensions ? member(*extensions, name) : std::nullopt;
}

std::size_t element_count(const JsonPlace& array) {
  if (!array.value->is_array()) refuse(array, "it must be an array");
  return array.value->size();
}

JsonPlace element(const JsonPlace& array, std::size_t index) {
  return {&(*array.value)[index], fmt::format("{}/{}", array.pointer, index), array.file};
}

JsonPlace indexed_element(const JsonPlace& place, const JsonPlace& object, std::string_view key) {
  const auto array = member(object, key);
  const std::size_t count = array ? element_count(*array) : 0, index = whole_number(place);
  if (index >= count)
    refuse(place, fmt::format("there are {} in {}/{}, counted from 0", count, object.pointer, key));
  return element(*array, index);
}

double number_within(const JsonPlace& place, double least, double most) {
  if (!place.value->is_number()) refuse(place, "it must be a number");
  const double number = place.value->get<double>();
  if (!(number >= least && number <= most) || std::isinf(number)) {
    refuse(place, std::isinf(most) ? fmt::format("it must be at least {}", least)
                                   : fmt::format("it must be in [{}, {}]", least, most));
  }
  return number;
}

std::size_t whole_number(const JsonPlace& place) {
  if (!place.value->is_number_unsigned()) refuse(place, "it must be a whole number from 0 on");
  return place.value->get<std::size_t>();
}

double number_or(const JsonPlace& object, std::string_view key, double least, double most, double otherwise) {
  const auto found = member(object, key);
  return found ? number_within(*found, least, most) : otherwise;
}

std::array<double, 3> colour_or_white(const JsonPlace& object, std::string_view key, std::size_t size,
                                      double most) {
  std::array<double, 3> colour{1, 1, 1};
  const auto found = member(object, key);
  if (!found) return colour;
  if (element_count(*found) != size) refuse(*found, fmt::format("it must have {} numbers", size));
  for (std::size_t i = 0; i < size; ++i) {
    const double number = number_within(element(*found, i), 0, most);
    if (i < colour.size()) colour[i] = number;
  }
  return colour;
}

std::string_view text_at(const JsonPlace& place) {
  if (!place.value->is_string()) refuse(place, "it must be a text");
  return place.value->get_ref<const std::string&>();
}

}  // namespace shadefit::scene
