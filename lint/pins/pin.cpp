#include "lint/pins/pin.hpp"

#include <algorithm>

#include "lint/scan/characters.hpp"
#include "lint/scan/notation.hpp"

namespace shadefit::lint {
namespace {

constexpr std::string_view mark = "shadefit:", word_of_ignoring = "ignore";

bool is_of_pin_name(char c) {
  return is_of_name(c) || c == '-' || c == '.';
}

std::string_view without_blanks_behind(std::string_view text) {
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

/// The line before a mark, without the start of the comment; null if no comment starts there. Comments that
/// document begin with more: "//!<", "/**".
std::string_view before_comment(std::string_view line) {
  line = without_blanks_behind(line);
  for (const std::string_view begin :
       {"//!<", "///<", "/**<", "/*!<", "//!", "/**", "/*!", "//", "#", "/*", "<!--"}) {
    if (!line.ends_with(begin)) continue;
    line.remove_suffix(begin.size());
    while (line.ends_with('/')) line.remove_suffix(1);  // "///"
    return line;
  }
  return {};
}

/// The word after a mark, without the end of a sentence or of the comment.
std::string_view name_behind(std::string_view text) {
  while (text.starts_with(' ') || text.starts_with('\t')) text.remove_prefix(1);
  const auto end = std::find_if_not(text.begin(), text.end(), is_of_pin_name);
  std::string_view name = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  while (name.ends_with('.') || name.ends_with('-')) name.remove_suffix(1);
  return name;
}

/// Whether a member begins there: `v.x`, or `v.0` of a tuple, which is not a number.
bool begins_member(std::string_view line, std::size_t at) {
  return line[at] == '.' && at > 0 &&
         (is_of_name(line[at - 1]) || line[at - 1] == ')' || line[at - 1] == ']');
}

/// The number that a text begins with, unless more of a version or of a range follows: 1.2.3, 0..5.
std::string_view whole_number(std::string_view text) {
  const auto number = notation_at(text);
  if (!number) return {};
  const std::string_view rest = text.substr(number->length);
  const bool is_continued = rest.size() > 1 && rest[0] == '.' && (is_digit(rest[1]) || rest[1] == '.');
  return is_continued ? std::string_view{} : text.substr(0, number->length);
}

/// The end of a word, or of a number that is not decimal: 0x1.8p+1 is one number.
std::size_t end_of_other_number(std::string_view line, std::size_t at) {
  const bool is_hexadecimal = line[at] == '0' && at + 1 < line.size() && (line[at + 1] | 0x20) == 'x';
  const auto is_part = [&](std::size_t i) {
    const bool is_sign = line[i] == '+' || line[i] == '-';
    if (is_hexadecimal && is_sign) return (line[i - 1] | 0x20) == 'p';
    if (is_hexadecimal && line[i] == '\'') return true;  // separates digits
    return is_of_name(line[i]) || line[i] == '.';
  };
  ++at;
  while (at < line.size() && is_part(at)) ++at;
  return at;
}

/// The last number of a line; empty if there is none or if it is not decimal.
std::string_view last_number(std::string_view line) {
  std::string_view last;
  for (std::size_t i = 0; i < line.size();) {
    const std::string_view rest = line.substr(i);
    const bool is_member = begins_member(line, i);
    const bool is_number =
        !is_member && (is_digit(rest[0]) || (rest[0] == '.' && rest.size() > 1 && is_digit(rest[1])));
    if (is_number) last = whole_number(rest);
    if (is_number && !last.empty()) {
      i += last.size();
      continue;
    }
    if (is_number) {
      i = end_of_other_number(line, i);
      continue;
    }
    const bool is_word = is_member || is_of_name(rest[0]);
    ++i;
    while (is_word && i < line.size() && is_of_name(line[i])) ++i;
  }
  return last;
}

/// What stands behind the word, without the end of the comment.
std::string reason_in(std::string_view text) {
  for (const std::string_view end : {"*/", "-->"}) text = text.substr(0, text.find(end));
  const std::size_t first = text.find_first_not_of(" \t:"), last = text.find_last_not_of(" \t\r");
  if (first == std::string_view::npos || first > last) return "no reason given";
  return std::string(text.substr(first, last - first + 1));
}

}  // namespace

std::optional<std::string> ignore_reason(std::string_view line) {
  for (std::size_t at = line.find(mark); at != std::string_view::npos; at = line.find(mark, at + 1)) {
    const std::string_view rest = line.substr(at + mark.size()), word = name_behind(rest);
    if (word != word_of_ignoring || before_comment(line.substr(0, at)).data() == nullptr) continue;
    return reason_in(rest.substr(static_cast<std::size_t>(word.data() - rest.data()) + word.size()));
  }
  return std::nullopt;
}

std::vector<Pin> pins_of(std::string_view text) {
  std::vector<Pin> pins;
  std::size_t free = 0;  // after the last mark
  for (std::size_t at = text.find(mark); at != std::string_view::npos; at = text.find(mark, at + 1)) {
    const std::size_t end = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
    const std::size_t line = std::max(free, end == std::string_view::npos ? 0 : end + 1);
    const std::string_view before = before_comment(text.substr(line, at - line));
    const std::string_view name = name_behind(text.substr(at + mark.size()));
    if (before.data() == nullptr || name.empty() || name == word_of_ignoring) continue;
    const std::string_view number = last_number(before);
    const auto offset_of = [&](std::string_view part) {
      return static_cast<std::size_t>(part.data() - text.data());
    };
    pins.push_back({offset_of(name), name, number.empty() ? 0 : offset_of(number), number});
    free = offset_of(name) + name.size();
  }
  return pins;
}

}  // namespace shadefit::lint
