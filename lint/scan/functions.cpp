#include "lint/scan/functions.hpp"

#include <algorithm>
#include <array>

#include "lint/scan/characters.hpp"

namespace shadefit::lint {
namespace {

/// The longest parameters of a function, and the longest text between them and the body: "-> f32", ":
/// SV_Target".
constexpr std::size_t most_bytes_of_parameters = 1000, most_bytes_of_result = 40;

template <std::size_t N>
bool is_one_of(std::string_view word, const std::array<std::string_view, N>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool is_control(std::string_view word) {
  constexpr std::array<std::string_view, 10> words{"if",      "for",  "while", "switch", "catch",
                                                   "foreach", "elif", "match", "with",   "constexpr"};
  return is_one_of(word, words);
}

bool is_keyword(std::string_view word) {
  constexpr std::array<std::string_view, 4> words{"def", "fn", "func", "function"};
  return is_one_of(word, words);
}

/// Where the name that ends there begins.
std::size_t name_begin(std::string_view text, std::size_t end) {
  while (end > 0 && is_of_name(text[end - 1])) --end;
  return end;
}

/// The parenthesis that closes the parameters before a brace, or the end of the text.
std::size_t closing_before(std::string_view text, std::size_t brace) {
  const std::size_t least = brace - std::min(brace, most_bytes_of_result);
  for (std::size_t i = brace; i > least; --i) {
    const char c = text[i - 1];
    if (c == ')') return i - 1;
    if (!is_blank(c) && !is_of_name(c) && std::string_view(":<>-").find(c) == std::string_view::npos) break;
  }
  return text.size();
}

/// The parenthesis that opens before the one that closes, or the end of the text.
std::size_t opening_before(std::string_view text, std::size_t closing) {
  const std::size_t least = closing - std::min(closing, most_bytes_of_parameters);
  int depth = 0;
  for (std::size_t i = closing + 1; i > least; --i) {
    if (text[i - 1] == ')') ++depth;
    if (text[i - 1] == '(' && --depth == 0) return i - 1;
    if (text[i - 1] == ';' || text[i - 1] == '{' || text[i - 1] == '}') break;
  }
  return text.size();
}

/// The name of a function whose body begins with this brace, or the end of the text.
std::size_t name_before(std::string_view text, std::size_t brace) {
  const std::size_t closing = closing_before(text, brace);
  if (closing == text.size()) return closing;
  std::size_t end = opening_before(text, closing);
  if (end == text.size()) return end;
  while (end > 0 && is_blank(text[end - 1])) --end;
  const std::size_t begin = name_begin(text, end);
  return begin == end || is_control(text.substr(begin, end - begin)) ? text.size() : begin;
}

}  // namespace

std::vector<std::size_t> function_begins(std::string_view text) {
  std::vector<std::size_t> begins;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '{') {
      const std::size_t name = name_before(text, i);
      if (name < text.size()) begins.push_back(name);
    } else if (text[i] == 'd' || text[i] == 'f') {
      const std::size_t first = i;
      if (i > 0 && is_of_name(text[i - 1])) continue;
      while (i + 1 < text.size() && is_of_name(text[i + 1])) ++i;
      if (is_keyword(text.substr(first, i + 1 - first))) begins.push_back(i + 1);
    }
  }
  std::sort(begins.begin(), begins.end());
  return begins;
}

}  // namespace shadefit::lint
