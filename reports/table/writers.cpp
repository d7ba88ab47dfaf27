#include "reports/table/writers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "fit/support/sweep.hpp"
#include "reports/io/utf8.hpp"

namespace shadefit {
namespace {

using Texts = std::vector<std::vector<std::string>>;

Texts texts(const Table& table, Precision precision) {
  Texts rows;
  for (const auto& row : table.rows) {
    auto& cells = rows.emplace_back();
    for (const Cell& cell : row) cells.push_back(text(cell, precision));
  }
  return rows;
}

/// Code points, which is what a terminal shows one cell for in the texts of this project.
std::size_t width(const std::string& s) {
  return static_cast<std::size_t>(
      std::count_if(s.begin(), s.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

std::vector<std::size_t> widths(const Table& table, const Texts& rows, std::size_t least) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    std::size_t widest = std::max(least, width(table.columns[i]));
    for (const auto& row : rows) widest = std::max(widest, width(row[i]));
    result.push_back(widest);
  }
  return result;
}

/// Whether a column holds no text, for each: looked at once a table, not once a row.
std::vector<bool> numeric_columns(const Table& table) {
  std::vector<bool> are_numeric(table.columns.size(), true);
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i)
      are_numeric[i] = are_numeric[i] && !std::holds_alternative<std::string>(row[i]);
  }
  return are_numeric;
}

std::string padded(const std::string& s, std::size_t to, bool right) {
  const std::string space(to - width(s), ' ');
  return right ? space + s : s + space;
}

std::string csv_cell(const std::string& s) {
  if (s.find_first_of(",\"\n\r") == std::string::npos) return s;
  std::string quoted = "\"";
  for (const char c : s) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

std::string csv_line(const std::vector<std::string>& cells) {
  std::string line;
  for (const auto& cell : cells) line += (&cell == &cells.front() ? "" : ",") + csv_cell(cell);
  return line + '\n';
}

std::string without_pipes(std::string s) {
  for (std::size_t i = 0; (i = s.find('|', i)) != std::string::npos; i += 2) s.insert(i, 1, '\\');
  return s;
}

/// A character as LaTeX has to be told it; the font's own encoding has no <, > and | in its text.
std::string latex_character(char c) {
  constexpr std::array<std::pair<char, std::string_view>, 6> named{{{'\\', "\\textbackslash{}"},
                                                                    {'~', "\\textasciitilde{}"},
                                                                    {'^', "\\textasciicircum{}"},
                                                                    {'<', "\\textless{}"},
                                                                    {'>', "\\textgreater{}"},
                                                                    {'|', "\\textbar{}"}}};
  const auto* found = std::find_if(named.begin(), named.end(), [&](const auto& n) { return n.first == c; });
  if (found != named.end()) return std::string(found->second);
  const bool is_special = std::string_view("&%$#_{}").find(c) != std::string_view::npos;
  const bool is_control = static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
  return is_special ? std::string{'\\', c} : std::string(1, is_control ? ' ' : c);
}

std::string latex_number(const std::string& s) {
  const auto e = s.find_first_of("eE");
  if (e == std::string::npos) return "$" + s + "$";
  std::string power = s.substr(e + 1);
  const bool is_negative = power.starts_with('-');
  power.erase(0, std::min(power.find_first_not_of("+-0"), power.size() - 1));
  return "$" + s.substr(0, e) + "\\times10^{" + (is_negative ? "-" : "") + power + "}$";
}

std::string latex_cell(const std::string& s) {
  if (parse_number(s)) return latex_number(s);
  // At the start of a row LaTeX takes [..] and * for arguments of the row before it.
  std::string out = s.starts_with('[') || s.starts_with('*') ? "{}" : "";
  for (const char c : s) out += latex_character(c);
  return out;
}

std::string latex_line(const std::vector<std::string>& cells) {
  std::string line;
  for (const auto& cell : cells) line += (&cell == &cells.front() ? "" : " & ") + latex_cell(cell);
  return line + " \\\\\n";
}

}  // namespace

std::string write_csv(const Table& table, Precision precision) {
  std::string out = csv_line(table.columns);
  for (const auto& row : texts(table, precision)) out += csv_line(row);
  return out;
}

std::string write_markdown(const Table& table, Precision precision) {
  auto rows = texts(table, precision);
  for (auto& row : rows) std::transform(row.begin(), row.end(), row.begin(), without_pipes);
  const auto width_of = widths(table, rows, 3);
  const std::vector<bool> are_numeric = numeric_columns(table);
  const auto line = [&](const std::vector<std::string>& cells) {
    std::string out = "|";
    for (std::size_t i = 0; i < cells.size(); ++i)
      out += " " + padded(cells[i], width_of[i], are_numeric[i]) + " |";
    return out + "\n";
  };
  std::string out = line(table.columns) + "|";
  for (std::size_t i = 0; i < width_of.size(); ++i) {
    const std::string dashes(width_of[i] + 1, '-');
    out += are_numeric[i] ? dashes + ":|" : ":" + dashes + "|";
  }
  out += "\n";
  for (const auto& row : rows) out += line(row);
  return out;
}

std::string write_latex(const Table& table, Precision precision) {
  const std::vector<bool> are_numeric = numeric_columns(table);
  std::string out = "% needs \\usepackage{booktabs}\n\\begin{tabular}{";
  for (std::size_t i = 0; i < table.columns.size(); ++i) out += are_numeric[i] ? 'r' : 'l';
  out += "}\n\\toprule\n" + latex_line(table.columns) + "\\midrule\n";
  for (const auto& row : texts(table, precision)) out += latex_line(row);
  return out + "\\bottomrule\n\\end{tabular}\n";
}

std::string markdown_block(const Table& table) {
  return write_markdown(table, Precision::report) + "\n";
}

std::string write_console(const Table& table, Precision precision) {
  auto rows = texts(table, precision);
  for (auto& row : rows) std::transform(row.begin(), row.end(), row.begin(), printable);
  const auto width_of = widths(table, rows, 0);
  const std::vector<bool> are_numeric = numeric_columns(table);
  const auto line = [&](const std::vector<std::string>& cells) {
    std::string out;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      out += (i == 0 ? "" : "  ") + padded(cells[i], width_of[i], are_numeric[i]);
    }
    out.erase(out.find_last_not_of(' ') + 1);
    return out + "\n";
  };
  std::string out = line(table.columns);
  for (const auto& row : rows) out += line(row);
  return out;
}

nlohmann::ordered_json write_json(const Table& table) {
  auto array = nlohmann::ordered_json::array();
  for (const auto& row : table.rows) {
    auto& object = array.emplace_back(nlohmann::ordered_json::object());
    for (std::size_t i = 0; i < row.size(); ++i) {
      auto& value = object[table.columns[i]];
      if (const auto* word = std::get_if<std::string>(&row[i])) value = *word;
      if (const auto* whole = std::get_if<long>(&row[i])) value = *whole;
      if (const auto* number = std::get_if<Number>(&row[i])) value = number->value;
    }
  }
  return array;
}

}  // namespace shadefit
