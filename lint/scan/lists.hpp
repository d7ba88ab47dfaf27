#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "lint/scan/literals.hpp"

/// Whether numbers of a text are a list.
namespace shadefit::lint {

/// Whether the numbers from the first to the last literal are a whole list: (a, b, c), or assignments in turn
/// to names that differ only in r, g, b, in red, green, blue, or in letters or digits that follow each other:
/// LUMA_R = .., LUMA_G = .., LUMA_B = ..
bool is_whole_list(std::string_view text, const std::vector<Literal>& literals, std::size_t first,
                   std::size_t last);

/// Whether all of them have as many digits behind the point.
bool have_same_decimals(std::string_view text, const std::vector<Literal>& literals, std::size_t first,
                        std::size_t last);

/// Whether these literals are equally far apart in one list, as the column of a matrix is. At least three.
bool is_column(std::string_view text, const std::vector<Literal>& literals,
               const std::vector<std::size_t>& places);

}  // namespace shadefit::lint
