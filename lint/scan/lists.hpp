#pragma once

#include <cstddef>
#include <string_view>

#include "lint/scan/literals.hpp"

/// Whether numbers of a text are a list.
namespace shadefit::lint {

/// Whether the numbers from the first to the last literal are a whole list: (a, b, c), perhaps with a 0
/// behind them as in vec4(a, b, c, 0.0).
bool is_whole_list(const ScannedText& text, std::size_t first, std::size_t last);

/// Whether a number with its sign is the first one in brackets.
bool begins_list(std::string_view text, const Literal& literal);

/// Whether a number with its sign is an argument, an element or the right side of an assignment, and not an
/// operand: 1.0 in vec2(1.0, x), not in 1.0 / x.
bool stands_alone(std::string_view text, const Literal& literal);

/// Whether all of them have as many digits behind the point.
bool have_same_decimals(const ScannedText& text, std::size_t first, std::size_t last);

/// A list of this many numbers is a table: among so many, some are near published ones.
inline constexpr std::size_t least_table = 64;

/// Whether the numbers from the first to the last literal are in one list of at least `least_table` numbers,
/// perhaps of lists or of vectors: {{0.1, 0.2}, {0.3, 0.4}}. Its comments do not matter.
bool is_in_table(const ScannedText& text, std::size_t first, std::size_t last);

}  // namespace shadefit::lint
