#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "fit/support/lines.hpp"
#include "fit/support/others_text.hpp"

/// Rows of a measurement: the target of a study that has no formula.
namespace shadefit {

/// One number for each row in every list.
struct MeasuredRows {
  OthersText file;                          ///< its name, for messages
  std::vector<std::vector<double>> places;  ///< the values of each variable
  std::vector<double> value = {};
  std::vector<double> sigma =
      {};                  ///< the standard deviation of each value; empty if the file does not have it
  std::size_t header = 1;  ///< the line that names the columns
};

/// One row from each of so many equal stretches of `count` rows, rising, from 0. The generator is
/// std::minstd_rand, whose numbers the standard fixes, so each machine draws the same.
std::vector<std::size_t> drawn_from(std::size_t count, std::size_t drawn);

/// Some of the rows, from 0.
MeasuredRows some_of(const MeasuredRows& all, const std::vector<std::size_t>& rows);

/// The most bytes of a file of rows, and the most rows.
inline constexpr std::uintmax_t most_row_bytes = 1 << 30;
inline constexpr std::size_t most_rows = 10000000;

/// The columns, in the order of the variables of a node: those of `places`, the values, sigma.
inline std::vector<const std::vector<double>*> columns_of(const MeasuredRows& rows) {
  std::vector<const std::vector<double>*> columns;
  for (const auto& places : rows.places) columns.push_back(&places);
  columns.push_back(&rows.value);
  if (!rows.sigma.empty()) columns.push_back(&rows.sigma);
  return columns;
}

/// The line of a row in its file. Both count from 1.
inline std::size_t line_of_row(const MeasuredRows& rows, std::size_t row) {
  return rows.header + row;
}

/// Reads the text of a file of values between commas, or between blanks and tabs. Its first line names the
/// columns: one for each variable, `measured`, and `sigma` if the standard deviations are known. Other
/// columns are ignored. A '#' may stand before the names, and before lines of comments above them. Lines may
/// end in CRLF, and the last one may have no end; a UTF-8 byte order mark and blanks around cells are
/// skipped. Numbers are decimals with a point, whatever the locale. Throws UserError with one line that names
/// the file, the line, the column and the rule: for a missing or repeated column, a quote, a row with too
/// many or too few cells, a cell that is not a finite number, a sigma that is not greater than 0, no rows,
/// and more than `most_rows`. Of the text it holds a part at a time; of a row 8 bytes a column remain.
MeasuredRows read_measured_rows(const TextParts& text, const std::string& file,
                                const std::vector<std::string>& variables,
                                const std::string& measured = "value");

}  // namespace shadefit
