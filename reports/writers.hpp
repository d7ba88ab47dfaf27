#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "reports/table.hpp"

/// One table, written for each kind of reader. Lines end in LF; nothing depends on the locale.
namespace shadefit {

/// RFC 4180, with a header line; a cell with a comma, quote or line break is quoted.
std::string write_csv(const Table& table, Precision precision);

/// A Markdown table, aligned in the source too; columns of numbers are right-aligned.
std::string write_markdown(const Table& table, Precision precision);

/// Aligned columns for a terminal, two spaces apart.
std::string write_console(const Table& table, Precision precision);

/// An array of objects, column to value; an empty cell is null. Numbers are numbers, to their shortest round
/// trip.
nlohmann::ordered_json write_json(const Table& table);

}  // namespace shadefit
