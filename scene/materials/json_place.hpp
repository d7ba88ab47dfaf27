#pragma once

#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

/// Reads values of a JSON document together with their places.
namespace shadefit::scene {

/// A value of a document, and its place by a JSON pointer (Bryan, Zyp, Nottingham 2013, RFC 6901). Refers to
/// the document and to the name of its file.
struct JsonPlace {
  const nlohmann::json* value;
  std::string pointer;
  std::string_view file;
};

/// "'scene.gltf': /materials/3".
std::string words_of(const JsonPlace& place);

/// Throws UserError with file, pointer, the value if it is short, and the rule that it breaks.
[[noreturn]] void refuse(const JsonPlace& place, std::string_view rule);

/// The member of an object, or nothing. Throws if `object` is not an object.
std::optional<JsonPlace> member(const JsonPlace& object, std::string_view key);

/// The member of an object, or an empty object in its place.
JsonPlace member_or_empty(const JsonPlace& object, std::string_view key);

/// A required member.
JsonPlace required_member(const JsonPlace& object, std::string_view key);

/// The extension of a glTF object by its name, or nothing.
std::optional<JsonPlace> extension(const JsonPlace& object, std::string_view name);

/// The number of elements of an array. Throws if it is not an array.
std::size_t element_count(const JsonPlace& array);

/// Element `index` < element_count(array).
JsonPlace element(const JsonPlace& array, std::size_t index);

/// Calls `use` with each element of the array `key` of an object, if it exists.
template <class Use>
void for_each_element(const JsonPlace& object, std::string_view key, const Use& use) {
  const auto array = member(object, key);
  for (std::size_t i = 0; array && i < element_count(*array); ++i) use(element(*array, i));
}

/// The element of the array `key` of `object` with the index stored at `place`. Throws if the index is not a
/// whole number or out of range.
JsonPlace indexed_element(const JsonPlace& place, const JsonPlace& object, std::string_view key);

/// A finite number in [least, most]; `most` may be infinite. Throws otherwise.
double number_within(const JsonPlace& place, double least, double most);

/// A number of bytes, whole and not negative. Throws otherwise.
std::size_t whole_number(const JsonPlace& place);

/// The member `key`, or `otherwise` if it is missing.
double number_or(const JsonPlace& object, std::string_view key, double least, double most, double otherwise);

/// The first three numbers of the member `key`, red, green, blue, each in [0, most]; white if it is missing.
/// Throws if it is not an array of `size` numbers.
std::array<double, 3> colour_or_white(const JsonPlace& object, std::string_view key, std::size_t size,
                                      double most);

std::string_view text_at(const JsonPlace& place);

}  // namespace shadefit::scene
