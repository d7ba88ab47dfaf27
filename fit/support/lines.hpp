#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

/// Texts that people wrote with any editor, line by line.
namespace shadefit {

/// Gives the parts of a long text, one after the other. None is empty, until the text ends.
using TextParts = std::function<std::string()>;

/// A text without the UTF-8 byte order mark that some editors write.
inline std::string_view without_mark(std::string_view text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

/// Removes the first line of a text with its end, which is LF, CR LF or CR.
inline std::string_view next_line(std::string_view& text) {
  const auto is_end = [](char c) { return c == '\n' || c == '\r'; };
  const auto end = static_cast<std::size_t>(std::ranges::find_if(text, is_end) - text.begin());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end);
  text.remove_prefix(text.starts_with("\r\n") ? 2 : std::min<std::size_t>(1, text.size()));
  return line;
}

/// A text without the blanks around it.
inline std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text.substr(0, text.find_last_not_of(blanks) + 1);  // npos + 1 is 0
}

}  // namespace shadefit
