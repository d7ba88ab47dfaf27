#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// The characters of programs: ASCII alone, whatever the locale. The kinds are objects, so that their calls
/// are inlined where a run of one kind is looked for.
namespace shadefit::lint {

inline constexpr auto is_digit = [](char c) { return '0' <= c && c <= '9'; };
inline constexpr auto is_letter = [](char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z'); };

/// Whether a name may have this character.
inline constexpr auto is_of_name = [](char c) { return is_letter(c) || is_digit(c) || c == '_'; };

inline constexpr auto is_blank_in_line = [](char c) { return c == ' ' || c == '\t'; };
inline constexpr auto is_blank = [](char c) { return is_blank_in_line(c) || c == '\r' || c == '\n'; };

constexpr bool is_one_of(char c, std::string_view these) {
  return these.find(c) != std::string_view::npos;
}

/// Where a run of such characters ends that begins there.
template <class Is>
constexpr std::size_t end_of_run(std::string_view text, std::size_t begin, const Is& is) {
  while (begin < text.size() && is(text[begin])) ++begin;
  return begin;
}

/// Where a run of such characters begins that ends there.
template <class Is>
constexpr std::size_t begin_of_run(std::string_view text, std::size_t end, const Is& is) {
  while (end > 0 && is(text[end - 1])) --end;
  return end;
}

/// Where the line with this place begins.
constexpr std::size_t line_begin(std::string_view text, std::size_t at) {
  return text.substr(0, at).rfind('\n') + 1;  // npos + 1 is 0
}

/// The line that begins there, without its end.
constexpr std::string_view line_at(std::string_view text, std::size_t begin) {
  return text.substr(begin, text.find('\n', begin) - begin);
}

/// The first place of a word outside of parentheses, or the end of the text.
inline std::size_t place_outside(std::string_view text, std::string_view word) {
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (depth == 0 && text.substr(i).starts_with(word)) return i;
    if (text[i] == '(' || text[i] == '[') ++depth;
    if (text[i] == ')' || text[i] == ']') --depth;
  }
  return text.size();
}

/// Whether a statement goes on behind the end of a line: `last` has the last character before it, or `next`
/// the first behind it.
inline bool goes_on(std::string_view text, std::size_t line_end, std::string_view last,
                    std::string_view next) {
  const std::size_t before = begin_of_run(text, line_end, is_blank),
                    behind = end_of_run(text, line_end, is_blank);
  return (before > 0 && is_one_of(text[before - 1], last)) ||
         (behind < text.size() && is_one_of(text[behind], next));
}

/// The text in lower case.
inline std::string in_small_letters(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

}  // namespace shadefit::lint
