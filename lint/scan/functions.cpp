#include <algorithm>
#include <array>

#include "lint/scan/characters.hpp"
#include "lint/scan/sites.hpp"

namespace shadefit::lint {
namespace {

/// The longest parameters of a function, and the longest text between them and the body: "-> f32", ":
/// SV_Target".
constexpr std::size_t most_bytes_of_parameters = 1000, most_bytes_of_result = 40;

bool is_control(std::string_view word) {
  constexpr std::array<std::string_view, 10> words{"if",      "for",  "while", "switch", "catch",
                                                   "foreach", "elif", "match", "with",   "constexpr"};
  return std::ranges::find(words, word) != words.end();
}

/// The parenthesis that closes the parameters before a brace, or the end of the text.
std::size_t closing_before(std::string_view text, std::size_t brace) {
  const std::size_t least = brace - std::min(brace, most_bytes_of_result);
  for (std::size_t i = brace; i > least; --i) {
    const char c = text[i - 1];
    if (c == ')') return i - 1;
    if (!is_blank(c) && !is_of_name(c) && !is_one_of(c, ":<>-")) break;
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
    if (is_one_of(text[i - 1], ";{}")) break;
  }
  return text.size();
}

/// The name of a function whose body begins with this brace, or the end of the text.
std::size_t name_before(std::string_view text, std::size_t brace) {
  const std::size_t closing = closing_before(text, brace);
  if (closing == text.size()) return closing;
  const std::size_t opening = opening_before(text, closing);
  if (opening == text.size()) return opening;
  const std::size_t end = begin_of_run(text, opening, is_blank), begin = begin_of_run(text, end, is_of_name);
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
      if (i > 0 && is_of_name(text[i - 1])) continue;
      const std::size_t end = end_of_run(text, i, is_of_name);
      const std::string_view word = text.substr(i, end - i);
      if (word == "def" || word == "fn" || word == "func" || word == "function") begins.push_back(end);
      i = end - 1;
    }
  }
  std::ranges::sort(begins);
  return begins;
}

}  // namespace shadefit::lint
