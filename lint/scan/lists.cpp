#include "lint/scan/lists.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "lint/scan/characters.hpp"
#include "lint/scan/notation.hpp"

namespace shadefit::lint {
namespace {

/// Whether one of these brackets is directly before, or behind, a number and its sign.
bool is_next_to(std::string_view text, const Literal& number, bool before, std::string_view brackets) {
  const std::string_view rest =
      before ? text.substr(0, number.offset) : text.substr(number.offset + number.length);
  const std::string_view blanks = before ? " \t\r\n+-" : " \t\r\n";
  const std::size_t at = before ? rest.find_last_not_of(blanks) : rest.find_first_not_of(blanks);
  return at != std::string_view::npos && brackets.find(rest[at]) != std::string_view::npos;
}

std::string_view between(std::string_view text, const Literal& a, const Literal& b) {
  const std::size_t end = a.offset + a.length;
  return text.substr(end, b.offset - end);
}

/// The text from the start of the assignment to its number, without blanks and in lower case.
std::string left_side(std::string_view text, const Literal& number) {
  const std::string_view before = text.substr(0, number.offset);
  const std::size_t end = before.find_last_of(";,{}()\n");
  std::string left;
  for (const char c : before.substr(end == std::string_view::npos ? 0 : end + 1))
    if (!is_blank(c)) left += 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return left;
}

std::size_t common_begin(const std::vector<std::string>& texts) {
  std::size_t count = texts.front().size();
  for (const std::string& text : texts) {
    const auto [mine, other] =
        std::mismatch(texts.front().begin(), texts.front().end(), text.begin(), text.end());
    count = std::min(count, static_cast<std::size_t>(mine - texts.front().begin()));
  }
  return count;
}

/// What is left of the texts without their common begin and end.
std::vector<std::string> differences_of(std::vector<std::string> texts) {
  for (int side = 0; side < 2; ++side) {
    const std::size_t common = common_begin(texts);
    for (std::string& text : texts) {
      text.erase(0, common);
      std::reverse(text.begin(), text.end());
    }
  }
  return texts;
}

/// r, g, b; red, green, blue; or a, b, c and x, y, z and 0, 1, 2.
bool follow_each_other(const std::vector<std::string>& names) {
  constexpr std::array<std::string_view, 3> letters{"r", "g", "b"};
  constexpr std::array<std::string_view, 3> colours{"red", "green", "blue"};
  const auto are = [&](const std::array<std::string_view, 3>& words) {
    return std::equal(names.begin(), names.end(), words.begin(), words.end());
  };
  if (are(letters) || are(colours)) return true;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i].size() != 1 || !is_of_name(names[i].front()) ||
        names[i].front() != names.front().front() + static_cast<char>(i))
      return false;
  return true;
}

/// Whether the numbers are assigned, one after the other, to such names.
bool are_assigned_in_turn(std::string_view text, const std::vector<Literal>& literals, std::size_t first,
                          std::size_t last) {
  std::vector<std::string> lefts;
  for (std::size_t i = first; i <= last; ++i) {
    lefts.push_back(left_side(text, literals[i]));
    if (i == first) continue;
    // Only the end of the statement and the next left side.
    std::string_view rest = between(text, literals[i - 1], literals[i]);
    rest = rest.substr(0, rest.find_last_of(";,{}()\n") + 1);
    if (rest.empty() ||
        !std::all_of(rest.begin(), rest.end(), [](char c) { return is_blank(c) || c == ';' || c == ','; }))
      return false;
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
  return !rest.empty() && std::string_view(")]}").find(rest.front()) != std::string_view::npos;
}

/// Whether this text between two numbers is that of a list of lists: a comma, signs and brackets, or the
/// constructor of the next row.
bool are_next_in_list(std::string_view rest) {
  const std::size_t end = rest.find_last_not_of(" \t\r\n+-");
  const bool has_constructor = end != std::string_view::npos && rest[end] == '(';
  const auto is_of_list = [&](char c) {
    return is_blank(c) || std::string_view(",+-()[]{}").find(c) != std::string_view::npos ||
           (has_constructor && (is_of_name(c) || c == '<' || c == '>'));
  };
  return std::count(rest.begin(), rest.end(), ',') == 1 && std::all_of(rest.begin(), rest.end(), is_of_list);
}

}  // namespace

bool is_whole_list(std::string_view text, const std::vector<Literal>& literals, std::size_t first,
                   std::size_t last) {
  const bool is_in_brackets = begins_list(text, literals[first]) && ends_list(text, literals[last]);
  return is_in_brackets || are_assigned_in_turn(text, literals, first, last);
}

bool begins_list(std::string_view text, const Literal& literal) {
  return is_next_to(text, literal, true, "([{");
}

bool stands_alone(std::string_view text, const Literal& literal) {
  return is_next_to(text, literal, true, "(,{[=") && is_next_to(text, literal, false, ",)}];");
}

bool have_same_decimals(std::string_view text, const std::vector<Literal>& literals, std::size_t first,
                        std::size_t last) {
  const auto decimals = [&](const Literal& literal) {
    const auto number = notation_at(text.substr(literal.offset, literal.length));
    return number && number->exponent.empty() ? number->fraction.size() : 0;
  };
  const std::size_t count = decimals(literals[first]);
  for (std::size_t i = first; i <= last; ++i)
    if (decimals(literals[i]) != count) return false;
  return count > 0;
}

bool is_column(std::string_view text, const std::vector<Literal>& literals,
               const std::vector<std::size_t>& places) {
  constexpr std::size_t least_numbers = 3;
  if (places.size() < least_numbers || places[1] < places[0] + 2) return false;
  for (std::size_t i = 1; i < places.size(); ++i)
    if (places[i] != places[i - 1] + places[1] - places[0]) return false;
  for (std::size_t i = places.front(); i < places.back(); ++i)
    if (!are_next_in_list(between(text, literals[i], literals[i + 1]))) return false;
  return true;
}

}  // namespace shadefit::lint
