#pragma once

#include <string>
#include <string_view>

#include "lint/scan/literals.hpp"

/// Programs inside other texts, byte for byte at the same places.
namespace shadefit::lint {

/// A text with comments as a program: without the signs of the comments, and with each word of prose a
/// statement of its own. "// by exp2(a * x) for" is "; by;exp2(a * x);for".
std::string comment_as_program(std::string_view text);

/// The text with strings of consecutive lines as one program. Their quotes, the `\n` before them and the
/// signs between them, `+` or a backslash, are blanks; a semicolon stands for the first quote and for the
/// last one. So a shader that is written as one string for each line can be read.
std::string with_joined_strings(std::string_view text, CommentStyle style);

}  // namespace shadefit::lint
