#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lint/scan/literals.hpp"

/// Statements of programs.
namespace shadefit::lint {

struct Statement {
  std::size_t begin = 0, end = 0;  ///< in the text
  std::string text;
  char sign = '\0';  ///< what ends it: a semicolon, a brace, a comma or the end of the line
};

/// "float3 a = x * 2": the name a, the operator (0, or that of *=) and the right side. "return x": no name.
struct Assignment {
  std::string name;
  char operation = '\0';
  std::string right;
};

/// Empty for a comparison and for what has no name on its left side.
std::optional<Assignment> assignment_of(std::string_view statement);

/// The first place of a word outside of parentheses, or the end of the text.
std::size_t place_outside(std::string_view text, std::string_view word);

/// Whether a statement goes on behind the end of a line: `last` has the last character before it, or `next`
/// the first behind it.
bool goes_on(std::string_view text, std::size_t line_end, std::string_view last, std::string_view next);

/// The text without the backslashes that join its lines, as in the body of a macro.
std::string with_joined_lines(std::string_view text);

/// The statements, with each `if` and what belongs to it as one choice: "if (x < t) return a; return b;" is
/// "return (x < t) ? (a) : (b)". Each branch has to be one statement, and both return a value or assign to
/// one name; other ones stay as they are.
std::vector<Statement> with_choices(std::vector<Statement> statements, CommentStyle style);

}  // namespace shadefit::lint
