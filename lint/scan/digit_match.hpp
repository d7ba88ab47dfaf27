#pragma once

#include <optional>

#include "lint/scan/literals.hpp"

/// How a number of a source text agrees with a published one.
namespace shadefit::lint {

/// From the closest to the loosest.
enum class DigitMatch {
  same,     ///< the same digits
  longer,   ///< more digits, which round to the published ones
  float32,  ///< the digits of the float nearest to the published number, or others of that float
  rounded,  ///< fewer digits, rounded or cut off
  shifted,  ///< the same digits, with the decimal point elsewhere
  edited,   ///< one digit differs, is missing or too many, or two neighbours are swapped
};

/// The fewest digits of a published number for a match other than the same digits: of fewer, too many numbers
/// are near.
inline constexpr std::size_t least_digits_to_vary = 4;

/// Compares a number without its sign; empty if it is another number.
std::optional<DigitMatch> match_digits(const Digits& found, const Digits& published);

/// Whether the digits are the first ones of the published number, rounded or cut off.
bool is_shortened(const Digits& found, const Digits& published);

/// The number with these digits.
double number_of(const Digits& digits);

}  // namespace shadefit::lint
