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

}  // namespace shadefit::lint
