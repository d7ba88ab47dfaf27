#pragma once

#include <string>
#include <string_view>

namespace shadefit::lint {

/// A text with comments as a program, byte for byte at the same places: without the signs of the comments,
/// and with each word of prose a statement of its own. "// by exp2(a * x) for" is "; by;exp2(a * x);for".
std::string comment_as_program(std::string_view text);

}  // namespace shadefit::lint
