#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace shadefit::lint {

/// Where functions begin, in rising order: after `def`, `fn`, `func` and `function`, and at the name of
/// "float f(float x) {" unless it is a keyword such as if or for.
std::vector<std::size_t> function_begins(std::string_view text);

}  // namespace shadefit::lint
