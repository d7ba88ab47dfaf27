#include "fit/study/measured_rows.hpp"

#include <algorithm>
#include <random>
#include <string_view>
#include <utility>

#include "fit/support/decimal.hpp"
#include "fit/support/lines.hpp"
#include "fit/support/user_error.hpp"

namespace shadefit {
namespace {

/// Longer names and cells are cut in messages.
constexpr std::size_t most_shown = 40;
/// A line with more cells is not a row of a measurement.
constexpr std::size_t most_columns = 1000;
constexpr std::size_t most_line = 1 << 20;

std::string shown(std::string_view cell) {
  return "'" + std::string(cell.substr(0, most_shown)) + (cell.size() > most_shown ? " ..'" : "'");
}

/// A name of a column, if it is a plain word; else only where it stands: the file may be any file, and its
/// content is not for messages.
std::string shown_name(std::string_view name, std::size_t column) {
  const bool is_word = std::ranges::all_of(name, [](char c) {
    return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '_';
  });
  return is_word ? shown(name) : "column " + std::to_string(column + 1);
}

/// The text of a file of rows, line by line. It holds a part of the text, and the line that the part cuts.
class RowReader {
 public:
  RowReader(TextParts next_part, const std::string& file)
      : file_("'" + file + "'"), next_part_(std::move(next_part)) {
    fill();
    rest_ = without_mark(rest_);
    if (!has_more()) throw UserError(file_ + " is empty: its first line must name the columns");
    columns_ = header();
    header_ = line_;
    for (std::size_t i = 0; i < columns_.size(); ++i) require_column_name(i);
  }

  const std::string& file() const { return file_; }
  std::size_t line_of_header() const { return header_; }
  /// Reads on if it must: then the cells of the last row are gone.
  bool has_more() {
    fill();
    return !rest_.empty();
  }
  bool has_column(std::string_view name) const { return std::ranges::find(columns_, name) != columns_.end(); }

  std::size_t column(std::string_view name) const {
    if (!has_column(name)) {
      std::string list;
      for (std::size_t i = 0; i < columns_.size(); ++i)
        list += (list.empty() ? "" : ", ") + shown_name(columns_[i], i);
      throw UserError(file_ + " has no column " + shown(name) + "; it has " + list +
                      (name == "value" ? ": --value names the measured one" : ""));
    }
    return static_cast<std::size_t>(std::ranges::find(columns_, name) - columns_.begin());
  }

  void next_row() {
    split(next(), cells_);
    if (cells_.size() != columns_.size())
      refuse("has " + std::to_string(cells_.size()) + (cells_.size() == 1 ? " cell" : " cells") +
             ", the header has " + std::to_string(columns_.size()));
  }

  double number(std::size_t column) const {
    std::string_view cell = cells_[column];
    if (cell.starts_with('+') && !cell.starts_with("+-")) cell.remove_prefix(1);
    const auto number = parse_number(cell);
    if (!number) refuse_cell(column, "is not a finite number");
    return *number;
  }

  /// Throws a UserError about a cell of the last row.
  [[noreturn]] void refuse_cell(std::size_t column, const std::string& rule) const {
    refuse(columns_[column] + " " + shown(cells_[column]) + " " + rule);
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw UserError(file_ + ", line " + std::to_string(line_) + ": " + what);
  }

  /// Reads parts until there is a whole line, or the text ends.
  void fill() {
    while (rest_.empty() && !is_ended_) {
      const std::string part = next_part_();
      // A byte 0 would cut a message off, and no text has one.
      if (part.find('\0') != std::string::npos) throw UserError(file_ + " is not a text: it has a byte 0");
      is_ended_ = part.empty();
      text_ = text_.substr(whole_) + part;
      // A CR at the end of a part may be that of CR LF.
      const std::string_view ended(text_.data(), text_.size() - (text_.ends_with('\r') ? 1 : 0));
      whole_ = is_ended_ ? text_.size() : ended.find_last_of("\r\n") + 1;  // npos + 1 is 0
      if (whole_ == 0 && text_.size() > most_line) {
        ++line_;
        refuse("more than " + std::to_string(most_line) + " bytes");
      }
      rest_ = std::string_view(text_).substr(0, whole_);
    }
  }

  std::string_view next() {
    ++line_;
    return next_line(rest_);
  }

  /// Between commas; of a line without one between blanks and tabs.
  void split(std::string_view line, std::vector<std::string_view>& cells) const {
    if (line.find('"') != std::string_view::npos) refuse("a quote: write numbers and names without quotes");
    const bool has_comma = line.find(',') != std::string_view::npos;
    line = trimmed(line);
    cells.clear();
    for (;;) {
      const std::size_t end = has_comma ? line.find(',') : line.find_first_of(" \t");
      cells.push_back(trimmed(line.substr(0, end)));
      if (cells.size() > most_columns) refuse("more than " + std::to_string(most_columns) + " cells");
      if (end == std::string_view::npos) return;
      line.remove_prefix(end + 1);
      if (!has_comma) line = trimmed(line);
    }
  }

  /// The names of the columns. As np.savetxt writes them, they stand behind a '#'; lines of comments may
  /// stand before them.
  std::vector<std::string> header() {
    std::string line(next());
    while (line.starts_with('#') && has_more()) {
      std::string_view rest = rest_;
      split(next_line(rest), cells_);
      if (std::ranges::any_of(cells_, [](std::string_view cell) { return parse_number(cell).has_value(); }))
        break;
      line = next();
    }
    split(std::string_view(line).substr(line.starts_with('#') ? 1 : 0), cells_);
    return {cells_.begin(), cells_.end()};
  }

  void require_column_name(std::size_t i) const {
    const std::string_view name = columns_[i];
    if (name.empty()) refuse("column " + std::to_string(i + 1) + " has no name");
    if (parse_number(name))
      refuse("column " + std::to_string(i + 1) + " is a number: the first line must name the columns");
    if (std::count(columns_.begin(), columns_.end(), name) > 1)
      refuse(shown_name(name, i) + " is there twice");
  }

  std::string file_;
  TextParts next_part_;
  std::string text_;
  std::size_t whole_ = 0;  ///< the length of the whole lines in it
  std::string_view rest_;  ///< of these lines
  bool is_ended_ = false;
  std::size_t line_ = 0, header_ = 0;
  std::vector<std::string> columns_;
  std::vector<std::string_view> cells_;
};

}  // namespace

std::vector<std::size_t> drawn_from(std::size_t count, std::size_t drawn) {
  std::minstd_rand random;
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < drawn; ++k) {
    const std::size_t begin = k * count / drawn, end = (k + 1) * count / drawn;
    rows.push_back(begin + random() % (end - begin));
  }
  return rows;
}

MeasuredRows some_of(const MeasuredRows& all, const std::vector<std::size_t>& rows) {
  MeasuredRows some = {
      .file = all.file, .places = {all.places.size(), std::vector<double>{}}, .header = all.header};
  for (const std::size_t row : rows) {
    for (std::size_t i = 0; i < all.places.size(); ++i) some.places[i].push_back(all.places[i][row]);
    some.value.push_back(all.value[row]);
    if (!all.sigma.empty()) some.sigma.push_back(all.sigma[row]);
  }
  return some;
}

MeasuredRows read_measured_rows(const TextParts& text, const std::string& file,
                                const std::vector<std::string>& variables, const std::string& measured) {
  RowReader reader(text, file);
  MeasuredRows rows{file, std::vector<std::vector<double>>(variables.size()), {}, {}};
  rows.header = reader.line_of_header();
  std::vector<std::size_t> places;
  for (const std::string& variable : variables) places.push_back(reader.column(variable));
  const std::size_t value = reader.column(measured);
  const bool has_sigma = reader.has_column("sigma");
  const std::size_t sigma = has_sigma ? reader.column("sigma") : value;
  while (reader.has_more()) {
    reader.next_row();
    if (rows.value.size() == most_rows)
      throw UserError(reader.file() + " has more than " + std::to_string(most_rows) + " rows");
    for (std::size_t i = 0; i < places.size(); ++i) rows.places[i].push_back(reader.number(places[i]));
    rows.value.push_back(reader.number(value));
    if (!has_sigma) continue;
    rows.sigma.push_back(reader.number(sigma));
    if (!(rows.sigma.back() > 0)) reader.refuse_cell(sigma, "must be greater than 0");
  }
  if (rows.value.empty()) throw UserError(reader.file() + " has no rows below its header");
  for (auto& column : rows.places) column.shrink_to_fit();
  rows.value.shrink_to_fit();
  rows.sigma.shrink_to_fit();
  return rows;
}

}  // namespace shadefit
