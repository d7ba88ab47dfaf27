#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "approx/cosine.hpp"

/// The result record: one table, several writers.
namespace shadefit {

/// A number and the significant digits of it that mean something. A checked report never shows rounding
/// noise.
struct Number {
  double value;
  int digits;
};

/// For `Number::digits`: as many as the shortest decimal needs to read back as the same double.
inline constexpr int all_digits = 17;

/// Nothing, a word or sentence, a whole number, or a number.
using Cell = std::variant<std::monostate, std::string, long, Number>;

struct Table {
  std::vector<std::string> columns;
  std::vector<std::vector<Cell>> rows;
};

enum class Precision {
  report,  ///< the digits that each number declares: the same bytes on every compiler and machine
  full,    ///< the shortest decimal that reads back as the same double
};

/// The text of a cell; free of the locale. Negative zero prints as 0.
std::string text(const Cell& cell, Precision precision);

Cell word(std::string_view text);

/// The table, no number with more than `most` digits.
Table with_digits(Table table, int most);

/// 10 digits: a converged parameter, or an error that was computed without cancellation.
Number converged(double value);

/// The cosine of a place: 6 digits, or as many more as leave three of 1 - c, where sharp lobes have theirs.
Cell place(const Cosine<double>& at);

/// A difference of `minuend` minus something, to the decimals that the ten digits of the minuend reach.
Cell difference(double value, double minuend);

/// `value` where it is at least `floor`, else 0: below its floor a difference is rounding.
Cell above_floor(double value, double floor);

}  // namespace shadefit
