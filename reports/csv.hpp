#pragma once

#include <string>
#include <vector>

/// Reading CSV back.
namespace shadefit {

struct CsvTable {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

/// Parses RFC 4180 with a header line. Throws UserError naming `name`, the line and the rule where the text
/// is empty or cut off (a last line without its end, an open quote) or a row has another number of cells than
/// the header.
CsvTable parse_csv(const std::string& content, const std::string& name);

}  // namespace shadefit
