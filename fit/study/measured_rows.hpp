#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fit/support/others_text.hpp"

/// Rows of a measurement: the target of a study that has no formula.
namespace shadefit {

/// One number for each row in every list.
struct MeasuredRows {
  OthersText file;                          ///< its name, for messages
  std::vector<std::vector<double>> places;  ///< the values of each variable
  std::vector<double> value;
  std::vector<double> sigma;  ///< the standard deviation of each value; empty if the file does not have it
  std::size_t header = 1;     ///< the line that names the columns
};

/// The most bytes of a file of rows, and the most rows.
inline constexpr std::uintmax_t most_row_bytes = 16 << 20;
inline constexpr std::size_t most_rows = 100000;

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
/// and more than `most_rows`.
MeasuredRows read_measured_rows(std::string_view text, const std::string& file,
                                const std::vector<std::string>& variables,
                                const std::string& measured = "value");

}  // namespace shadefit
