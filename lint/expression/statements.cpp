#include "lint/expression/statements.hpp"

#include <algorithm>
#include <utility>

#include "lint/scan/characters.hpp"

namespace shadefit::lint {
namespace {

/// The last name of "const float3 a", of "let a: f32" the one before the colon.
std::string assigned_name(std::string_view left) {
  left = trimmed(left.substr(0, left.find(':')));
  const auto is_of_path = [](char c) { return is_of_name(c) || c == '.'; };
  return std::string(left.substr(begin_of_run(left, left.size(), is_of_path)));
}

}  // namespace

std::size_t place_outside(std::string_view text, std::string_view word) {
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (depth == 0 && text.substr(i).starts_with(word)) return i;
    if (text[i] == '(' || text[i] == '[') ++depth;
    if (text[i] == ')' || text[i] == ']') --depth;
  }
  return text.size();
}

bool goes_on(std::string_view text, std::size_t line_end, std::string_view last, std::string_view next) {
  const std::size_t before = begin_of_run(text, line_end, is_blank),
                    behind = end_of_run(text, line_end, is_blank);
  return (before > 0 && is_one_of(text[before - 1], last)) ||
         (behind < text.size() && is_one_of(text[behind], next));
}

std::optional<Assignment> assignment_of(std::string_view statement) {
  statement = trimmed(statement);
  constexpr std::string_view word = "return";
  if (statement.starts_with(word) && statement.size() > word.size() && !is_of_name(statement[word.size()]))
    return Assignment{"", '\0', std::string(statement.substr(word.size()))};
  for (std::size_t i = 1; i + 1 < statement.size(); ++i) {
    if (statement[i] == '(') break;
    if (statement[i] != '=') continue;
    if (statement[i + 1] == '>') break;  // c => a * c
    if (statement[i + 1] == '=' || is_one_of(statement[i - 1], "=<>!")) return std::nullopt;
    const bool is_compound = is_one_of(statement[i - 1], "+-*/");
    const std::size_t sign = is_compound ? i - 1 : i - (statement[i - 1] == ':' ? 1 : 0);
    std::string name = assigned_name(statement.substr(0, sign));
    if (name.empty()) return std::nullopt;
    return Assignment{std::move(name), is_compound ? statement[i - 1] : '\0',
                      std::string(statement.substr(i + 1))};
  }
  // The last expression of a function in Rust.
  return Assignment{"", '\0', std::string(statement)};
}

}  // namespace shadefit::lint
