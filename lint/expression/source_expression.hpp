#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fit/scalars/symbolic.hpp"
#include "lint/scan/literals.hpp"

/// The expression around numbers of a source text.
namespace shadefit::lint {

/// An expression of a program as a formula. Its names are v0, v1, ..; a call of an unknown function, a member
/// and an element of an array are names too. A vector of one number, `vec3(x)`, is that number.
struct SourceExpression {
  Symbolic formula;
  std::vector<std::string> names;  ///< of v0, v1, .. in the text
};

/// The expressions around the bytes [begin, end), from the smallest that has balanced parentheses to the
/// whole right side of the statement.
std::vector<std::string_view> expressions_around(std::string_view text, std::size_t begin, std::size_t end);

/// Reads an expression of GLSL, HLSL, C, JavaScript, Python, Rust and their kin. Empty if it has more than
/// scalars' operations: vectors of several numbers, assignments, unknown signs.
std::optional<SourceExpression> read_expression(std::string_view text, CommentStyle style);

}  // namespace shadefit::lint
