#pragma once

#include <optional>

#include "lint/scan/literals.hpp"

/// How a number of a source text agrees with a published one.
namespace shadefit::lint {

/// From the closest to the loosest.
enum class DigitMatch {
  same,        ///< the same digits
  longer,      ///< more digits, which round to the published ones
  float32,     ///< the digits of the float nearest to the published number, or others of that float
  rounded,     ///< fewer digits, rounded or cut off
  shifted,     ///< the same digits, with the decimal point elsewhere
  usual_slip,  ///< see is_usual_slip()
  edited,      ///< one digit differs, is missing or too many, or two neighbours are swapped
};

/// The fewest digits of a published number for a match other than `same`. With fewer, too many numbers are
/// near.
inline constexpr std::size_t least_digits_to_vary = 4;

/// Compares a number without its sign. Empty if it is another number. It never answers `usual_slip`, which is
/// for numbers of few digits.
std::optional<DigitMatch> match_digits(const Digits& found, const Digits& published);

/// Whether the digits are the first ones of the published number, rounded or cut off.
bool is_shortened(const Digits& found, const Digits& published);
bool is_rounded(const Digits& found, const Digits& published);
bool is_cut(const Digits& found, const Digits& published);

/// Whether two neighbours are swapped, or the other one of two digits is doubled: 578 for 587, 229 for 299.
/// These are the slips of a person who knows the number; a number of three digits has at most two of them.
bool is_usual_slip(const Digits& found, const Digits& published);

/// Whether one digit is replaced, or two neighbours are swapped.
bool is_edited(const Digits& found, const Digits& published);

/// Whether the numbers may be equal but for rounding, which may add a leading digit. Most numbers that are
/// compared differ in this, and the other comparisons are slow.
bool have_near_exponents(const Digits& found, const Digits& published);

/// Whether a number of at least seven digits has the float nearest to the published one.
bool is_same_float(const Digits& found, const Digits& published);

/// The number with these digits.
double number_of(const Digits& digits);

}  // namespace shadefit::lint
