#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "fit/support/user_error.hpp"
#include "reports/io/csv.hpp"
#include "reports/io/utf8.hpp"

namespace {

/// Tables equal, cell by cell.
bool is_same(const shadefit::CsvTable& a, const shadefit::CsvTable& b) {
  return a.columns == b.columns && a.rows == b.rows;
}

std::string line_of(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& cell : cells) {
    if (&cell != &cells.front()) line += ',';
    line += '"';
    for (const char c : cell) line += c == '"' ? std::string("\"\"") : std::string(1, c);
    line += '"';
  }
  return line + '\n';
}

}  // namespace

// One input is a table of a baseline. What is read is read again where it is written with quotes around all.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace shadefit;
  const std::string content(reinterpret_cast<const char*>(data), size);
  try {
    const CsvTable table = parse_csv(content, "a.csv");
    std::string again = line_of(table.columns);
    for (const auto& row : table.rows) again += line_of(row);
    if (!is_same(parse_csv(again, "a.csv"), table)) std::abort();
  } catch (const UserError& error) {
    if (one_line(error.what()).size() > 6000) std::abort();  // refused, in a line of a bounded length
  }
  return 0;
}
