#pragma once

#include <algorithm>
#include <string_view>

/// Lines and words of Wavefront's formats.
namespace shadefit::scene {

/// Removes the first line of a text, including its "
/// ", "\r
/// " or "\r".
inline std::string_view next_line(std::string_view& text) {
  const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end);
  text.remove_prefix(text.starts_with("\r\n") ? 2 : std::min<std::size_t>(1, text.size()));
  return line;
}

/// A line's first word, and the trimmed rest.
struct Words {
  std::string_view key, values;
};

inline Words words_of_line(std::string_view line) {
  constexpr std::string_view blanks = " \t";
  const auto trimmed = [&](std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
    return text.substr(0, text.find_last_not_of(blanks) + 1);  // npos + 1 is 0
  };
  const std::string_view text = trimmed(line);
  const std::size_t end = std::min(text.find_first_of(blanks), text.size());
  return {text.substr(0, end), trimmed(text.substr(end))};
}

/// A text without the UTF-8 byte order mark that some editors write.
inline std::string_view without_mark(std::string_view text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

}  // namespace shadefit::scene
