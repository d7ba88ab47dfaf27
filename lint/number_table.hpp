#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "lint/scan/literals.hpp"

namespace shadefit::lint {

/// A list of this many numbers is a table: among so many, some are near published ones.
inline constexpr std::size_t least_table = 64;

/// Whether the numbers from the first to the last literal are in one list of at least `least_table` numbers,
/// perhaps of lists or of vectors: {{0.1, 0.2}, {0.3, 0.4}}. Its comments do not matter.
bool is_in_table(std::string_view text, CommentStyle style, const std::vector<Literal>& literals,
                 std::size_t first, std::size_t last);

}  // namespace shadefit::lint
