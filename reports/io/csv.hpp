#pragma once

#include <string>
#include <vector>

/// Reading CSV back.
namespace shadefit {

struct CsvTable {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

/// Parses RFC 4180 with a header line, LF and no line breaks inside cells: what `write_csv` writes of our
/// tables. Throws UserError naming `name`, the line and the rule where the text is empty, cut off, not plain
/// UTF-8, badly quoted, or has a row with another number of cells than the header.
CsvTable parse_csv(const std::string& content, const std::string& name);

}  // namespace shadefit
