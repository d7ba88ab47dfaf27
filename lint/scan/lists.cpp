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

/// The text from the start of the assignment to its number, without blanks and in lower case.
std::string left_side(std::string_view text, const Literal& number) {
  const std::string_view before = text.substr(0, number.offset);
  std::string left = in_small_letters(before.substr(before.find_last_of(";,{}()\n") + 1));  // npos + 1 is 0
  std::erase_if(left, is_blank);
  return left;
}

std::size_t common_begin(const std::vector<std::string>& texts) {
  const std::string& first = texts.front();
  auto end = first.end();
  for (const std::string& text : texts) end = std::min(end, std::ranges::mismatch(first, text).in1);
  return static_cast<std::size_t>(end - first.begin());
}

/// What is left of the texts without their common begin and end.
std::vector<std::string> differences_of(std::vector<std::string> texts) {
  for (int side = 0; side < 2; ++side) {
    const std::size_t common = common_begin(texts);
    for (std::string& text : texts) {
      text.erase(0, common);
      std::ranges::reverse(text);
    }
  }
  return texts;
}

/// r, g, b; red, green, blue; or a, b, c and x, y, z and 0, 1, 2.
bool follow_each_other(const std::vector<std::string>& names) {
  if (names == std::vector<std::string>{"r", "g", "b"}) return true;
  if (names == std::vector<std::string>{"red", "green", "blue"}) return true;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i].size() != 1 || !is_of_name(names[i].front()) ||
        names[i].front() != names.front().front() + static_cast<char>(i))
      return false;
  return true;
}

/// Whether the numbers are assigned, one after the other, to such names.
bool are_assigned_in_turn(const ScannedText& text, std::size_t first, std::size_t last) {
  std::vector<std::string> lefts;
  for (std::size_t i = first; i <= last; ++i) {
    lefts.push_back(left_side(text.text, text.literals[i]));
    if (i == first) continue;
    // Only the end of the statement and the next left side.
    std::string_view rest = text_between(text, i - 1, i);
    rest = rest.substr(0, rest.find_last_of(";,{}()\n") + 1);
    if (rest.empty() || rest.find_first_not_of(" \t\r\n;,") != std::string_view::npos) return false;
  }
  return lefts.size() > 1 && follow_each_other(differences_of(std::move(lefts)));
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
  return (begins_list(text.text, text.literals[first]) && ends_list(text.text, text.literals[last])) ||
         are_assigned_in_turn(text, first, last);
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
    const auto number = notation_at(text.text.substr(text.literals[i].offset, text.literals[i].length));
    counts.insert(number && number->exponent.empty() ? number->fraction.size() : 0);
  }
  return counts.size() == 1 && *counts.begin() > 0;
}

bool is_column(const ScannedText& text, const std::vector<std::size_t>& places) {
  constexpr std::size_t least_numbers = 3;
  if (places.size() < least_numbers || places[1] < places[0] + 2) return false;
  for (std::size_t i = 1; i < places.size(); ++i)
    if (places[i] != places[i - 1] + places[1] - places[0]) return false;
  for (std::size_t i = places.front(); i < places.back(); ++i) {
    const std::string_view between = text_between(text, i, i + 1);
    if (std::ranges::count(between, ',') != 1 || !is_between_elements(between)) return false;
  }
  return true;
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
    const std::string_view between = text_between(text, std::min(literal, next), std::max(literal, next));
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
