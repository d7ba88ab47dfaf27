#include "reports/io/writers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <boost/algorithm/string/replace.hpp>
#include <functional>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "fit/steps/status.hpp"
#include "fit/verdicts/verdict.hpp"
#include "reports/io/escape.hpp"
#include "reports/io/joined.hpp"
#include "reports/io/mathematics.hpp"
#include "reports/io/utf8.hpp"

namespace shadefit {
namespace {

using Texts = std::vector<std::vector<std::string>>;

/// The texts of the cells, those of others as `escaped` makes them, ours as `ours` does.
Texts texts(const Table& table, Precision precision, std::string (*escaped)(const OthersText&),
            const std::function<std::string(const std::string&)>& ours = {}) {
  Texts rows;
  for (const auto& row : table.rows) {
    auto& cells = rows.emplace_back();
    for (const Cell& cell : row) {
      const auto* others = std::get_if<OthersText>(&cell);
      const std::string of_us = others != nullptr ? "" : printable(text(cell, precision));
      cells.push_back(others != nullptr ? escaped(*others) : ours ? ours(of_us) : of_us);
    }
  }
  return rows;
}

/// The number of code points: in this project's texts each takes one cell of a terminal.
std::size_t width(const std::string& s) {
  return static_cast<std::size_t>(std::ranges::count_if(s, [](char c) { return (c & 0xC0) != 0x80; }));
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

/// For each column, whether it has no text.
std::vector<bool> numeric_columns(const Table& table) {
  std::vector<bool> are_numeric(table.columns.size(), true);
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      const bool has_words =
          std::holds_alternative<std::string>(row[i]) || std::holds_alternative<OthersText>(row[i]);
      are_numeric[i] = are_numeric[i] && !has_words;
    }
  }
  return are_numeric;
}

std::string padded(const std::string& s, std::size_t to, bool right) {
  const std::string space(to - width(s), ' ');
  return right ? space + s : s + space;
}

std::string csv_cell(const std::string& s) {
  if (s.find_first_of(",\"\n\r") == std::string::npos) return s;
  return '"' + boost::replace_all_copy(s, "\"", "\"\"") + '"';
}

std::string csv_line(const std::vector<std::string>& cells) {
  return joined(cells, ",", csv_cell) + '\n';
}

/// "max_abs_error" as "max abs error".
std::vector<std::string> in_words(std::vector<std::string> titles) {
  for (std::string& title : titles) std::ranges::replace(title, '_', ' ');
  return titles;
}

/// At the start of a row, LaTeX reads [..] and * as arguments of the row before.
std::string latex_start(const std::string& s) {
  return (s.starts_with('[') || s.starts_with('*') ? "{}" : "") + s;
}

std::string latex_words(const OthersText& s) {
  return latex_start(for_latex(s));
}

/// "`c^k` falls" as "$c^{k}$ falls"; nothing for a text without marks, or whose marks hold no formulas.
std::optional<std::string> latex_statement(const std::string& s) {
  if (s.find('`') == std::string::npos) return {};
  try {
    return with_mathematics(s, [](const std::string& words) { return for_latex(words); });
  } catch (const std::invalid_argument&) {
    return {};
  }
}

using MoreNames = std::span<const std::string>;

std::string latex_cell(const std::string& s, MoreNames names) {
  if (const auto mathematics = latex_mathematics(s, names)) return *mathematics;
  // "at c": the title of a column of places.
  if (s.starts_with("at ")) {
    if (const auto place = latex_mathematics(s.substr(3), names)) return "at " + *place;
  }
  return latex_start(latex_statement(s).value_or(for_latex(s)));
}

std::string latex_line(const std::vector<std::string>& cells) {
  return joined(cells, " & ") + " \\\\\n";
}

/// A column on a terminal.
struct ConsoleColumn {
  std::size_t index;  ///< in the table
  std::string title;
  bool is_numeric;
  std::size_t width;
  std::size_t least;  ///< width to which its cells can be folded
  std::size_t rank;   ///< the lowest one is dropped first
};

constexpr std::size_t never_dropped = 10'000;

bool is_largest_error(const std::string& title) {
  return title == "largest residual" || title == "max error at least" ||
         (title.starts_with("max ") && title.ends_with(" error"));
}

/// The place of a column in the order in which they are dropped: details first, then from the right. Last go
/// what a reader came for: the constants, where they are from, and the first of the largest errors or its
/// bounds. What all rows are about stays: the verdict; of a comparison the form and what it costs. There the
/// verdict and the sources go before the errors do.
std::size_t rank_of(const std::vector<std::string>& titles, std::size_t place) {
  constexpr std::array<std::string_view, 7> details{"operations", "digits",    "status",   "at c",
                                                    "under",      "published", "rms error"};
  constexpr std::size_t of_comparison = 1000, last = 2000;
  if (place == 0) return never_dropped;
  const std::string& title = titles[place];
  const auto* detail = std::ranges::find(details, title);
  if (detail != details.end()) return static_cast<std::size_t>(detail - details.begin());
  const bool is_comparison = std::ranges::find(titles, "instructions") != titles.end();
  if (is_comparison && title == "verdict") return of_comparison;
  if (is_comparison && title == "from") return of_comparison + 1;
  if (title == "verdict" || title == "form" || title == "instructions") return never_dropped;
  const std::size_t from_right = details.size() + titles.size() - place;
  const bool is_dropped_last =
      title == "constants" || title == "from" || title == "at most" ||
      (is_largest_error(title) &&
       std::ranges::find_if(titles, is_largest_error) - titles.begin() == static_cast<std::ptrdiff_t>(place));
  return is_dropped_last ? last + from_right : from_right;
}

std::vector<ConsoleColumn> console_columns(const Table& table, const Texts& rows) {
  // A narrower column of text is hard to read.
  constexpr std::size_t narrowest = 16;
  const auto width_of = widths(table, rows, 0);
  const std::vector<bool> are_numeric = numeric_columns(table);
  std::vector<ConsoleColumn> columns;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    std::size_t least = std::max(width(table.columns[i]), narrowest);
    for (const auto& row : rows) {
      for (const std::string& word : folded(row[i], 1)) least = std::max(least, width(word));
    }
    columns.push_back({i, table.columns[i], are_numeric[i], width_of[i],
                       are_numeric[i] ? width_of[i] : std::min(least, width_of[i]),
                       rank_of(table.columns, i)});
  }
  return columns;
}

/// Drops and narrows columns until all fit, as far as possible. Returns the titles of the dropped ones.
std::vector<std::string> fit_columns(std::vector<ConsoleColumn>& columns, std::size_t room) {
  const auto total = [&](std::size_t ConsoleColumn::*of) {
    std::size_t sum = 2 * (columns.size() - 1);
    for (const ConsoleColumn& column : columns) sum += column.*of;
    return sum;
  };
  std::vector<std::string> dropped;
  while (total(&ConsoleColumn::least) > room) {
    const auto next = std::ranges::min_element(columns, {}, &ConsoleColumn::rank);
    if (next->rank == never_dropped) break;
    dropped.push_back(next->title);
    columns.erase(next);
  }
  while (total(&ConsoleColumn::width) > room) {
    const auto slack = [](const ConsoleColumn& column) {
      return column.width > column.least ? column.width : 0;
    };
    const auto widest = std::ranges::max_element(
        columns, [&](const ConsoleColumn& a, const ConsoleColumn& b) { return slack(a) < slack(b); });
    if (slack(*widest) == 0) break;
    --widest->width;
  }
  return dropped;
}

}  // namespace

std::string write_csv(const Table& table, Precision precision) {
  std::string out = csv_line(table.columns);
  for (const auto& row : texts(table, precision, for_csv)) out += csv_line(row);
  return out;
}

std::string write_markdown(const Table& table, Precision precision) {
  const auto rows = texts(table, precision, for_markdown,
                          [](const std::string& ours) { return boost::replace_all_copy(ours, "|", "\\|"); });
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

std::string write_latex(const Table& table, Precision precision, std::span<const std::string> more_names) {
  const std::vector<bool> are_numeric = numeric_columns(table);
  std::string out = "% needs \\usepackage{booktabs}\n\\begin{tabular}{";
  for (std::size_t i = 0; i < table.columns.size(); ++i) out += are_numeric[i] ? 'r' : 'l';
  const auto cell = [&](const std::string& ours) { return latex_cell(ours, more_names); };
  std::vector<std::string> titles = in_words(table.columns);
  std::ranges::transform(titles, titles.begin(), cell);
  out += "}\n\\toprule\n" + latex_line(titles) + "\\midrule\n";
  for (const auto& row : texts(table, precision, latex_words, cell)) out += latex_line(row);
  return out + "\\bottomrule\n\\end{tabular}\n";
}

std::string markdown_block(Table table) {
  table.columns = in_words(std::move(table.columns));
  return write_markdown(table, Precision::report) + "\n";
}

std::vector<std::string> folded(std::string_view text, std::size_t most) {
  std::vector<std::string> words, lines;
  std::istringstream stream{std::string(text)};
  for (std::string word; stream >> word;) {
    const bool is_glued = !words.empty() && (word == "=" || words.back().ends_with(" ="));
    if (is_glued) {
      words.back() += " " + word;
    } else {
      words.push_back(word);
    }
  }
  for (const std::string& word : words) {
    if (!lines.empty() && width(lines.back()) + 1 + width(word) <= most) {
      lines.back() += " " + word;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

std::string with_coloured_verdicts(std::string text, const Terminal& terminal) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 6> colours{
      {{name(Verdict::confirmed), "\x1b[32m"},
       {name(Verdict::rounding), "\x1b[32m"},
       {name(Verdict::other_objective), "\x1b[35m"},
       {name(Verdict::conditional), "\x1b[35m"},
       {name(Verdict::refuted), "\x1b[31m"},
       {name(Status::not_converged), "\x1b[31m"}}};
  if (!terminal.has_colour) return text;
  for (const auto& [word, colour] : colours)
    boost::replace_all(text, word, fmt::format("{}{}\x1b[0m", colour, word));
  return text;
}

std::string write_console(const Table& table, Precision precision, const Terminal& terminal) {
  const auto rows = texts(table, precision, for_terminal);
  auto columns = console_columns(table, rows);
  const auto dropped =
      terminal.width == 0 ? std::vector<std::string>{} : fit_columns(columns, terminal.width);
  std::string out;
  const auto add_line = [&](const std::vector<std::string>& cells) {
    std::string line;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const std::string cell = padded(cells[i], columns[i].width, columns[i].is_numeric);
      const bool is_verdict = columns[i].title == "verdict";
      line += (i == 0 ? "" : "  ") + (is_verdict ? with_coloured_verdicts(cell, terminal) : cell);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    out += line + "\n";
  };
  std::vector<std::string> titles;
  for (const ConsoleColumn& column : columns) titles.push_back(column.title);
  add_line(titles);
  for (const auto& row : rows) {
    std::vector<std::vector<std::string>> cells;
    std::size_t height = 1;
    for (const ConsoleColumn& column : columns) {
      const std::string& cell = row[column.index];
      cells.push_back(width(cell) <= column.width ? std::vector{cell} : folded(cell, column.width));
      height = std::max(height, cells.back().size());
    }
    for (std::size_t i = 0; i < height; ++i) {
      std::vector<std::string> line;
      for (const auto& lines : cells) line.push_back(i < lines.size() ? lines[i] : "");
      add_line(line);
    }
  }
  if (!dropped.empty())
    out += fmt::format("{}\n", fmt::join(folded(fmt::format("(left out for the width of the terminal: {})",
                                                            fmt::join(dropped, ", ")),
                                                terminal.width),
                                         "\n"));
  return out;
}

nlohmann::ordered_json write_json(const Table& table) {
  auto array = nlohmann::ordered_json::array();
  for (const auto& row : table.rows) {
    auto& object = array.emplace_back(nlohmann::ordered_json::object());
    for (std::size_t i = 0; i < row.size(); ++i) {
      auto& value = object[table.columns[i]];
      if (const auto* word = std::get_if<std::string>(&row[i])) value = *word;
      if (const auto* others = std::get_if<OthersText>(&row[i])) value = *others;
      if (const auto* whole = std::get_if<long>(&row[i])) value = *whole;
      if (const auto* number = std::get_if<Number>(&row[i])) value = number->value;
    }
  }
  return array;
}

}  // namespace shadefit
