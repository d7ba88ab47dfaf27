#pragma once

#include <string>
#include <string_view>

/// Programs in comments.
namespace shadefit::lint {

/// A text with comments as a program, byte for byte at the same places: the signs of comments are blanks, and
/// a semicolon ends the code before them.
std::string comment_as_program(std::string_view text);

}  // namespace shadefit::lint
