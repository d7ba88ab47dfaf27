#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Texts of others as messages and tables show them.
namespace shadefit::scene {

/// A file may hold a name of 60 MB. What escapes or prints a text takes up to 40 times its memory.
inline constexpr std::size_t most_shown_bytes = 200;

/// The text itself, or its beginning and " .." where it is longer than that. UTF-8 stays whole.
inline std::string shortened(std::string_view text) {
  if (text.size() <= most_shown_bytes) return std::string(text);
  std::size_t end = most_shown_bytes;
  // A code point has at most three bytes after its first.
  for (int i = 0; i < 3 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80; ++i) --end;
  return std::string(text.substr(0, end)) + " ..";
}

}  // namespace shadefit::scene
