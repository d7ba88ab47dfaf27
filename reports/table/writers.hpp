#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "reports/table/table.hpp"

/// One table, written for each kind of reader. Lines end in LF; nothing depends on the locale.
namespace shadefit {

/// RFC 4180, with a header line; a cell with a comma, quote or line break is quoted.
std::string write_csv(const Table& table, Precision precision);

/// A Markdown table, aligned in the source too; columns of numbers are right-aligned.
std::string write_markdown(const Table& table, Precision precision);

/// A LaTeX tabular with the rules of booktabs, to \input; columns of numbers are right-aligned. What LaTeX
/// would read as a command is escaped, other UTF-8 left as it is; a cell that is a decimal number, a word
/// that reads as one too, is set as mathematics: 1.2e-05 as $1.2\times10^{-5}$.
std::string write_latex(const Table& table, Precision precision);

/// The same as a report shows it: the digits that each number declares, and an empty line behind.
std::string markdown_block(const Table& table);

/// Aligned columns for a terminal, two spaces apart; what could forge a line there is escaped.
std::string write_console(const Table& table, Precision precision);

/// An array of objects, column to value; an empty cell is null. Numbers are numbers, to their shortest round
/// trip.
nlohmann::ordered_json write_json(const Table& table);

}  // namespace shadefit
