#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// How a source text writes a decimal number.
namespace shadefit::lint {

/// The parts of "1.50e-3f": "1", "50", "e-3" and "f".
struct Notation {
  std::string_view whole, fraction;  ///< digits and their separators; at most one is empty
  bool has_point = false;
  std::string_view exponent;  ///< with its letter and its sign
  std::string_view suffix;
  std::size_t length = 0;  ///< of all parts
};

/// The parts of a number at the start of a text, without a sign: as much as can be read of them, with all
/// letters behind the digits as the suffix.
Notation parts_of_number(std::string_view text);

/// All digits without leading zeros: as printed, with trailing zeros.
std::string significant_digits(const Notation& number);

/// Whether these letters may follow a number: f, h, l, f32, f64. Any others make a word of it.
bool is_suffix(std::string_view letters);

/// Whether a factor such as "\times 10^{-13}" follows behind a number that ends there: a published number may
/// include it.
bool is_before_power_of_ten(std::string_view text, std::size_t end);

/// The published number, without its sign, in the notation of a literal: with its suffix, with or without a
/// zero before the point, and with the point at the same place before an exponent. "1.5e-3f" and "0.00142"
/// give "1.42e-3f". The published one may have a sign.
std::string rewritten(std::string_view literal, std::string_view published);

}  // namespace shadefit::lint
