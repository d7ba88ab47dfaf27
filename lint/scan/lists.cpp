#include "lint/scan/lists.hpp"

#include <algorithm>
#include <set>
#include <string>

#include "lint/scan/characters.hpp"
#include "lint/scan/notation.hpp"

namespace shadefit::lint {
namespace {

/// Whether one of these brackets is directly before, or behind, a number and its sign.
bool is_next_to(std::string_view text, const Literal& number, bool before, std::string_view brackets) {
  const std::string_view rest =
      before ? text.substr(0, number.offset) : text.substr(number.offset + number.length);
  const std::size_t at = before ? rest.find_last_not_of(" \t\r\n+-") : rest.find_first_not_of(" \t\r\n");
  return at != std::string_view::npos && is_one_of(rest[at], brackets);
}

/// Whether a number is the last one in brackets, perhaps but for a 0: vec4(a, b, c, 0.0).
bool ends_list(std::string_view text, const Literal& number) {
  std::string_view rest = text.substr(number.offset + number.length);
  const auto skip = [&](std::string_view these) {
    rest.remove_prefix(std::min(rest.find_first_not_of(these), rest.size()));
  };
  constexpr std::string_view blanks = " \t\r\n";
  skip(blanks);
  if (rest.starts_with(',')) {
    skip(" \t\r\n,");
    skip("0.fFhH");
    skip(blanks);
  }
  return !rest.empty() && is_one_of(rest.front(), ")]}");
}

/// Whether this text between two numbers has a comma and otherwise only signs, zeros, brackets and
/// constructors: "), vec3(0, -".
bool is_between_elements(std::string_view text) {
  bool has_comma = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    has_comma = has_comma || text[i] == ',';
    if (is_letter(text[i])) {
      i = end_of_run(text, i, [](char c) { return is_of_name(c) || c == '<' || c == '>'; });
      if (i == text.size() || !is_one_of(text[i], "([{")) return false;
    } else if (!is_blank(text[i]) && !is_one_of(text[i], ",+-()[]{}0.\\")) {
      return false;
    }
  }
  return has_comma;
}

}  // namespace

bool is_whole_list(const ScannedText& text, std::size_t first, std::size_t last) {
  return begins_list(text.text, text.literals[first]) && ends_list(text.text, text.literals[last]);
}

bool begins_list(std::string_view text, const Literal& literal) {
  return is_next_to(text, literal, true, "([{");
}

bool stands_alone(std::string_view text, const Literal& literal) {
  return is_next_to(text, literal, true, "(,{[=") && is_next_to(text, literal, false, ",)}];");
}

bool have_same_decimals(const ScannedText& text, std::size_t first, std::size_t last) {
  std::set<std::size_t> counts;
  for (std::size_t i = first; i <= last; ++i) {
    const Notation number =
        parts_of_number(text.text.substr(text.literals[i].offset, text.literals[i].length));
    counts.insert(number.exponent.empty() ? number.fraction.size() : 0);
  }
  return counts.size() == 1 && *counts.begin() > 0;
}

bool is_in_table(const ScannedText& text, std::size_t first, std::size_t last) {
  constexpr std::size_t longest = 400;
  const std::size_t none = text.literals.size();
  // The next number of the list outside of comments, behind or before one.
  const auto next_to = [&](std::size_t literal, bool is_behind) {
    std::size_t next = literal;
    do next = is_behind ? next + 1 : next - 1;  // 0 - 1 is beyond all
    while (next < none && text.literals[next].is_in_comment);
    if (next >= none) return none;
    const Literal &a = text.literals[std::min(literal, next)], &b = text.literals[std::max(literal, next)];
    const std::size_t end = a.offset + a.length;
    const std::string_view between = text.text.substr(end, b.offset - end);
    return between.size() <= longest && is_between_elements(with_blank_comments(between, text.style)) ? next
                                                                                                      : none;
  };
  std::size_t count = 1;
  for (std::size_t i = first; i < last; ++count) {
    i = next_to(i, true);
    if (i > last) return false;
  }
  for (const bool is_behind : {false, true})
    for (std::size_t i = next_to(is_behind ? last : first, is_behind); i != none && count < least_table;
         i = next_to(i, is_behind))
      ++count;
  return count >= least_table;
}

}  // namespace shadefit::lint
