#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fit/scalars/symbolic.hpp"
#include "lint/scan/literals.hpp"

/// The expression around numbers of a source text.
namespace shadefit::lint {

/// A text with comments as a program, byte for byte at the same places: the signs of comments are blanks, and
/// a semicolon ends the code before them.
std::string comment_as_program(std::string_view text);

/// The expressions around the bytes [begin, end): from the smallest one with balanced parentheses to the
/// whole right side of the statement.
std::vector<std::string_view> expressions_around(std::string_view text, std::size_t begin, std::size_t end);

/// Reads an expression of GLSL, HLSL, C, JavaScript, Python, Rust and similar languages as a formula of its
/// names. A call of an unknown function, a member and an element of an array are names too: "dot(n, l)". A
/// vector of one number, `vec3(x)`, is that number. Empty if it has other operations than those of scalars:
/// vectors of several numbers, assignments, unknown signs, comments.
std::optional<Symbolic> read_expression(std::string_view text, CommentStyle style);

/// read_expression(), or what remembers its answers.
using ReadExpression = std::function<std::optional<Symbolic>(std::string_view, CommentStyle)>;

/// The values of the statements around the bytes [begin, end), as formulas of the names that are not assigned
/// there. For
///   float a = x * (x + 0.0245786); float b = x * 0.983729 + 0.238081; return a / b;
/// the last value is a quotient in x. The list begins with the first value after the last of these bytes.
/// First come the values as formulas of what is computed before the bytes, then with its own formulas
/// inserted.
std::vector<Symbolic> values_around(std::string_view text, std::size_t begin, std::size_t end,
                                    CommentStyle style, const ReadExpression& read);

}  // namespace shadefit::lint
