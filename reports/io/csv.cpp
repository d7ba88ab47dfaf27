#include "reports/io/csv.hpp"

#include <fmt/format.h>

#include "fit/support/user_error.hpp"
#include "reports/io/utf8.hpp"

namespace shadefit {

namespace {

/// Refuses what our writers never write, such as a text that is cut off or that another program saved.
void require_plain_text(const std::string& content, const std::string& name) {
  if (content.empty()) throw UserError(fmt::format("'{}' is empty: a table needs a header line", name));
  if (content.starts_with("\xEF\xBB\xBF"))
    throw UserError(fmt::format("'{}' line 1 begins with a byte order mark: a table is plain UTF-8", name));
  std::size_t line = 1;
  for (std::size_t i = 0, length = 0; i < content.size(); i += length) {
    const char c = content[i];
    if (c == '\r')
      throw UserError(fmt::format("'{}' line {} has a carriage return: lines end in LF alone", name, line));
    const auto byte = static_cast<unsigned char>(c);
    if ((byte < 0x20 && c != '\n') || byte == 0x7F) {
      throw UserError(
          fmt::format("'{}' line {} holds the byte 0x{:02x}: a table is plain text", name, line, byte));
    }
    length = first_code_point(std::string_view(content).substr(i)).length;
    if (length == 0) {
      throw UserError(fmt::format("'{}' line {} holds the byte 0x{:02x} out of place: a table is UTF-8", name,
                                  line, byte));
    }
    line += c == '\n';
  }
  if (content.back() != '\n')
    throw UserError(fmt::format("'{}' line {} is truncated: it has no end", name, line));
}

/// The cells of one line; a quoted cell ends in its quote and doubles quotes inside.
std::vector<std::string> parse_line(const std::string& text, const std::string& name, std::size_t line) {
  const auto refuse = [&](const char* rule) {
    throw UserError(fmt::format("'{}' line {} {}", name, line, rule));
  };
  std::vector<std::string> cells;
  std::size_t i = 0;
  do {
    std::string& cell = cells.emplace_back();
    if (i < text.size() && text[i] == '"') {
      for (++i; i < text.size() && (text[i] != '"' || text.substr(i, 2) == "\"\""); ++i) {
        cell += text[i];
        i += text[i] == '"';
      }
      if (i == text.size()) refuse("opens a quote and never closes it");
      ++i;
      if (i < text.size() && text[i] != ',') refuse("has text after a closing quote");
    } else {
      for (; i < text.size() && text[i] != ','; ++i) cell += text[i];
      if (cell.find('"') != std::string::npos) refuse("has a quote inside a cell that is not quoted");
    }
  } while (i++ < text.size());
  return cells;
}

}  // namespace

CsvTable parse_csv(const std::string& content, const std::string& name) {
  require_plain_text(content, name);
  CsvTable table;
  std::size_t line = 1;
  for (std::size_t begin = 0; begin < content.size(); ++line) {
    const std::size_t end = content.find('\n', begin);
    auto cells = parse_line(content.substr(begin, end - begin), name, line);
    begin = end + 1;
    if (table.columns.empty()) {
      table.columns = std::move(cells);
    } else if (cells.size() == table.columns.size()) {
      table.rows.push_back(std::move(cells));
    } else {
      throw UserError(fmt::format("'{}' line {} has {} cells: the header has {}", name, line, cells.size(),
                                  table.columns.size()));
    }
  }
  return table;
}

}  // namespace shadefit
