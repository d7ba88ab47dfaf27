#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "approx/cosine.hpp"
#include "fit/support/others_text.hpp"

/// A table of results. Several writers print it.
namespace shadefit {

/// A number and its meaningful significant digits. A checked report never shows rounding noise.
struct Number {
  double value;
  int digits;
};

/// For `Number::digits`: the shortest decimal that reads back as the same double.
inline constexpr int all_digits = 17;

/// Nothing, a word or sentence of ours, a whole number, a number, or a text of others, which each writer
/// escapes for its place.
using Cell = std::variant<std::monostate, std::string, long, Number, OthersText>;

/// A number with all digits.
inline Cell all_of(double value) {
  return Number{value, all_digits};
}

struct Table {
  std::vector<std::string> columns;
  std::vector<std::vector<Cell>> rows = {};
};

enum class Precision {
  report,  ///< the digits that each number declares: the same bytes on every compiler and machine
  full,    ///< the shortest decimal that reads back as the same double
};

/// The text of a cell; free of the locale. Negative zero prints as 0. A text of others is as a terminal shows
/// it.
std::string text(const Cell& cell, Precision precision);

/// A number with so many digits, as a report prints it.
std::string in_digits(double value, int digits);

Cell word(std::string_view text);

/// The table with `count` columns from `first` on as one column of texts: "a = 1, b = 2".
Table with_columns_as_one(const Table& table, std::size_t first, std::size_t count, const std::string& title,
                          Precision precision);

/// These columns of the table, in this order.
Table columns_of(const Table& table, const std::vector<std::size_t>& places);

/// The table with rows as columns: the first column has the titles.
Table transposed(const Table& table);

/// 10 digits: a converged parameter, or an error that was computed without cancellation.
Number converged(double value);

/// The cosine of a place: 6 digits, or more near 1, where sharp lobes are, so that 1 - c has three digits.
Cell place(const Cosine<double>& at);

/// A difference, rounded to the last of the ten digits of its minuend.
Cell difference(double value, double minuend);

/// `value` where it is at least `floor`, else 0: below its floor a difference is rounding.
Cell above_floor(double value, double floor);

}  // namespace shadefit
