#pragma once

#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

/// Reading values of a JSON document with the place of each at hand.
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

/// Throws UserError: file, pointer, the value where it is a short one, and the rule that it breaks.
[[noreturn]] void refuse(const JsonPlace& place, std::string_view rule);

/// The member of an object; nothing where it has none. Throws where `object` is none.
std::optional<JsonPlace> member(const JsonPlace& object, std::string_view key);

/// A member that has to be there.
JsonPlace required_member(const JsonPlace& object, std::string_view key);

/// The extension of an object of glTF by its name; nothing where the object has none.
std::optional<JsonPlace> extension(const JsonPlace& object, std::string_view name);

/// How many elements an array has. Throws where it is none.
std::size_t element_count(const JsonPlace& array);

/// Element `index` < element_count(array).
JsonPlace element(const JsonPlace& array, std::size_t index);

/// The element of the array `key` of `object` that the index at `place` names. Throws where it is no whole
/// number, or there is no such element.
JsonPlace indexed_element(const JsonPlace& place, const JsonPlace& object, std::string_view key);

/// A number in [least, most]; `most` may be infinite, the number may not. Throws otherwise.
double number_within(const JsonPlace& place, double least, double most);

/// A whole number from 0 on, of bytes. Throws otherwise.
std::size_t whole_number(const JsonPlace& place);

/// The member `key`, or `otherwise` where there is none.
double number_or(const JsonPlace& object, std::string_view key, double least, double most, double otherwise);

/// The first three numbers of the member `key`, red, green, blue, each in [0, most]; 1 each where there is
/// none. Throws where it is no array of `size` numbers.
std::array<double, 3> colour_or_white(const JsonPlace& object, std::string_view key, std::size_t size,
                                      double most);

std::string_view text_at(const JsonPlace& place);

}  // namespace shadefit::scene
