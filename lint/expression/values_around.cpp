#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "fit/support/lines.hpp"
#include "lint/expression/source_expression.hpp"
#include "lint/scan/characters.hpp"

namespace shadefit::lint {
namespace {

/// The most statements that are read after the last number, and the most bytes before and after.
constexpr std::size_t most_statements_behind = 4;
constexpr std::size_t most_bytes_around = 700;

/// Named constants are read within this many bytes before the first number: let a = 1.0; let b = 0.03.
constexpr std::size_t most_bytes_before = 300;

/// A person does not write larger formulas.
constexpr std::size_t deepest_value = 60, most_parts_of_value = 1000;

struct Statement {
  std::size_t begin = 0, end = 0;  ///< in the text
  std::string text;
};

/// "float3 a = x * 2": the name a, the operator (0, or that of *=) and the right side. "return x": no name.
struct Assignment {
  std::string name;
  char operation = '\0';
  std::string right;
};

/// The last name of "const float3 a", of "let a: f32" the one before the colon.
std::string assigned_name(std::string_view left) {
  left = trimmed(left.substr(0, left.find(':')));
  const auto is_of_path = [](char c) { return is_of_name(c) || c == '.'; };
  return std::string(left.substr(begin_of_run(left, left.size(), is_of_path)));
}

/// Empty for a comparison and for what has no name on its left side.
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

/// Whether a formula has more parts than this; each use of a name counts, as in b = b * b - a, again and
/// again.
bool has_more_parts(const Symbolic& formula, std::size_t& left) {
  if (left-- == 0) return true;
  return std::ranges::any_of(formula.parts(),
                             [&](const Symbolic& part) { return has_more_parts(part, left); });
}

/// Whether a name and "=" follow: the next declaration of "float a = 2.51, b = 0.03".
bool begins_declaration(std::string_view text) {
  const std::size_t first = end_of_run(text, 0, is_blank), end = end_of_run(text, first, is_of_name);
  if (end == first || is_digit(text[first])) return false;
  const std::size_t sign = end_of_run(text, end, is_blank);
  return sign + 1 < text.size() && text[sign] == '=' && text[sign + 1] != '=';
}

/// The statements of a text from the one with `begin` on.
std::vector<Statement> statements_of(std::string_view text, std::size_t begin, std::size_t end,
                                     CommentStyle style) {
  // In Python a colon ends the head of a block; elsewhere it joins the parts of a choice.
  const std::string_view joining = style == CommentStyle::hash ? "+-*/(,=" : "+-*/(,?:=";
  const auto ends = [&](std::size_t i, int depth) {
    const char c = text[i];
    if (is_one_of(c, ";{}")) return true;
    // Python, Go, Swift and JavaScript end a statement with its line.
    if (c != '\n' || depth > 0) return false;
    return !goes_on(text, i, joining, "+-*/)?:.,");
  };
  std::size_t first = begin;
  const std::size_t least = begin - std::min(begin, most_bytes_around);
  while (first > least && !ends(first - 1, 0)) --first;
  std::vector<Statement> statements;
  std::size_t behind = 0;
  int depth = 0;
  const std::size_t most = std::min(text.size(), end + most_bytes_around);
  for (std::size_t i = first; i < most && behind <= most_statements_behind; ++i) {
    if (text[i] == '(' || text[i] == '[') ++depth;
    if (text[i] == ')' || text[i] == ']') --depth;
    if (!ends(i, depth) && !(text[i] == ',' && depth == 0 && begins_declaration(text.substr(i + 1))))
      continue;
    statements.push_back({first, i, std::string(text.substr(first, i - first))});
    if (i > first && i >= end) ++behind;
    if (text[i] == '}' && i >= end) break;  // the function ends
    first = i + 1;
    depth = 0;
  }
  return statements;
}

/// Where the block around a place begins, if that is near.
std::size_t block_begin(std::string_view text, std::size_t at) {
  const std::size_t least = at - std::min(at, most_bytes_before);
  const std::size_t brace = text.substr(least, at - least).find_last_of("{}");
  if (brace != std::string_view::npos) return least + brace + 1;
  const std::size_t line = text.find('\n', least);
  return least == 0 ? 0 : std::min(line, at);
}

Symbolic combined(char operation, const Symbolic& a, const Symbolic& b) {
  if (operation == '+') return a + b;
  if (operation == '-') return a - b;
  return operation == '*' ? a * b : a / b;
}

/// The values from the last number on. `keeps_all`: with everything that is computed before the first number
/// inserted, not only constants.
std::vector<Symbolic> values_of(const std::vector<Statement>& statements, std::size_t begin, std::size_t end,
                                CommentStyle style, const ReadExpression& read, bool keeps_all) {
  std::map<std::string, Symbolic> known;
  const auto value_of = [&](const std::string& name) {
    const auto found = known.find(name);
    return found == known.end() ? Symbolic::variable(name) : found->second;
  };
  std::vector<Symbolic> values;
  for (const Statement& statement : statements) {
    const auto assignment = assignment_of(statement.text);
    if (!assignment) continue;
    const auto right = read(trimmed(assignment->right), style);
    if (!right) {
      known.erase(assignment->name);
      continue;
    }
    Symbolic value = evaluate<Symbolic>(*right, value_of);
    if (statement.end <= begin && !keeps_all && !value.is_of_numbers()) continue;
    if (assignment->operation != '\0')
      value = combined(assignment->operation, value_of(assignment->name), value);
    std::size_t left = most_parts_of_value;
    if (value.depth() > deepest_value || has_more_parts(value, left)) return values;
    if (!assignment->name.empty()) known.insert_or_assign(assignment->name, value);
    if (statement.end >= end) values.push_back(value);
  }
  return values;
}

}  // namespace

std::vector<Symbolic> values_around(std::string_view text, std::size_t begin, std::size_t end,
                                    CommentStyle style, const ReadExpression& read) {
  const std::vector<Statement> statements = statements_of(text, block_begin(text, begin), end, style);
  std::vector<Symbolic> values = values_of(statements, begin, end, style, read, false);
  if (statements.empty() || statements.front().end > begin) return values;
  // The form may be one of x, after x = 1 - y (the values so far), or one of y, after t = y y (these values).
  for (Symbolic& value : values_of(statements, begin, end, style, read, true))
    values.push_back(std::move(value));
  return values;
}

}  // namespace shadefit::lint
