#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "fit/support/user_error.hpp"

/// Texts and places from files, for messages and tables.
namespace shadefit::scene {

/// Returns the result of `work`. Rethrows its UserError with the place in front: "'a.gltf': /images/3: ...".
template <class Work>
auto at_place(const std::string& place, const Work& work) {
  try {
    return work();
  } catch (const UserError& error) {
    throw UserError(place + ": " + error.what());
  }
}

/// A file may hold a name of 60 MB, and escaping or printing a text takes up to 40 times its memory.
inline constexpr std::size_t most_shown_bytes = 200;

/// The text, or its beginning and " .." if it is longer than that. UTF-8 characters are not split.
inline std::string shortened(std::string_view text) {
  if (text.size() <= most_shown_bytes) return std::string(text);
  std::size_t end = most_shown_bytes;
  // A code point has at most three bytes after its first.
  for (int i = 0; i < 3 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80; ++i) --end;
  return std::string(text.substr(0, end)) + " ..";
}

}  // namespace shadefit::scene
