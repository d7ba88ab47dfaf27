#include "reports/csv.hpp"

#include <fmt/format.h>

#include "fit/user_error.hpp"

namespace shadefit {

CsvTable parse_csv(const std::string& content, const std::string& name) {
  if (content.empty()) throw UserError(fmt::format("'{}' is empty: a table needs a header line", name));
  if (content.back() != '\n')
    throw UserError(fmt::format("'{}' is truncated: its last line has no end", name));
  CsvTable table;
  std::vector<std::string> row(1);
  std::size_t line = 1;
  bool is_quoted = false;
  for (std::size_t i = 0; i < content.size(); ++i) {
    const char c = content[i];
    if (is_quoted) {
      if (c != '"') {
        row.back() += c;
      } else if (content[i + 1] == '"') {
        row.back() += content[++i];
      } else {
        is_quoted = false;
      }
    } else if (c == '"' && row.back().empty()) {
      is_quoted = true;
    } else if (c == ',') {
      row.emplace_back();
    } else if (c == '\n') {
      if (table.columns.empty()) {
        table.columns = row;
      } else if (row.size() == table.columns.size()) {
        table.rows.push_back(row);
      } else {
        throw UserError(fmt::format("'{}' line {} has {} cells: the header has {}", name, line, row.size(),
                                    table.columns.size()));
      }
      row.assign(1, "");
      ++line;
    } else {
      row.back() += c;
    }
  }
  if (is_quoted) throw UserError(fmt::format("'{}' is truncated: a quote opened and never closed", name));
  return table;
}

}  // namespace shadefit
