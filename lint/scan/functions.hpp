#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace shadefit::lint {

/// Where functions begin, in rising order: behind `def`, `fn`, `func` and `function`, and at the name of
/// "float f(float x) {", which is none of if, for and their kin.
std::vector<std::size_t> function_begins(std::string_view text);

}  // namespace shadefit::lint
