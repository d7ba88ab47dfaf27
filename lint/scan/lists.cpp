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

/// Whether this text between two numbers is that of a list of lists: a comma, signs and brackets, or the
/// constructor of the next row.
bool are_next_in_list(std::string_view rest) {
  const std::size_t end = rest.find_last_not_of(" \t\r\n+-");
  const bool has_constructor = end != std::string_view::npos && rest[end] == '(';
  const auto is_of_list = [&](char c) {
    return is_blank(c) || is_one_of(c, ",+-()[]{}") ||
           (has_constructor && (is_of_name(c) || c == '<' || c == '>'));
  };
  return std::ranges::count(rest, ',') == 1 && std::ranges::all_of(rest, is_of_list);
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
  for (std::size_t i = places.front(); i < places.back(); ++i)
    if (!are_next_in_list(text_between(text, i, i + 1))) return false;
  return true;
}

}  // namespace shadefit::lint
