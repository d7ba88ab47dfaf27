#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reports/io/table.hpp"

/// One table, written for each kind of reader. Lines end in LF; nothing depends on the locale. A text of
/// others is escaped for its place, and in a text of ours too a character that a terminal does not show is
/// \xNN.
namespace shadefit {

/// RFC 4180, with a header line; a cell with a comma, quote or line break is quoted.
std::string write_csv(const Table& table, Precision precision);

/// A Markdown table, aligned in the source too; columns of numbers are right-aligned.
std::string write_markdown(const Table& table, Precision precision);

/// A LaTeX tabular with the rules of booktabs, for \input; titles in words, columns of numbers right-aligned.
/// A cell is set as mathematics if it is a number, a formula, a relation, or a list of those: 1.2e-05 as
/// $1.2\times10^{-5}$, "x = 0.775" as $x = 0.775$; so are the marked formulas of a statement
/// (reports/io/mathematics.hpp). In other cells what LaTeX would read as a command is escaped, and other
/// UTF-8 left as it is.
std::string write_latex(const Table& table, Precision precision,
                        std::span<const std::string> more_names = {});

/// A Markdown table for a report: titles in words, report precision, and an empty line at the end.
std::string markdown_block(Table table);

/// The device of a text.
struct Terminal {
  std::size_t width = 0;  ///< in letters; 0: a pipe or a file, without a limit
  bool has_colour = false;
};

/// Aligned columns, two spaces apart. Control characters are escaped. If the table is wider than the
/// terminal, columns are dropped, and a last line names them: details such as the digits first, then columns
/// from the right, the constants, their origin and the largest error last; the first column, the verdict, the
/// form and the instructions stay. Then cells of text are folded. No value is cut.
std::string write_console(const Table& table, Precision precision, const Terminal& terminal = {});

/// The text with the verdicts in it coloured, if the terminal has colours: green for agreement, magenta for
/// agreement in part, red for refuted. All three are readable on light and dark backgrounds.
std::string with_coloured_verdicts(std::string text, const Terminal& terminal);

/// The words of a text in lines of at most `width` letters; "a = 1" is one word. A longer word gets its own
/// line.
std::vector<std::string> folded(std::string_view text, std::size_t width);

/// An array of objects with the columns as keys; an empty cell is null. Numbers are shortest decimals that
/// read back.
nlohmann::ordered_json write_json(const Table& table);

}  // namespace shadefit
