#include "reports/studies/html.hpp"

#include <fmt/format.h>

#include <variant>
#include <vector>

#include "reports/io/escape.hpp"
#include "reports/studies/page_files.hpp"

namespace shadefit {
namespace {

/// The class of a text that begins with a verdict; otherwise empty.
std::string_view class_of_verdict(std::string_view words) {
  if (words.starts_with("confirmed") || words.starts_with("rounding")) return "confirmed";
  if (words.starts_with("other-objective") || words.starts_with("undecidable")) return "partly";
  return words.starts_with("refuted") ? "refuted" : "";
}

bool is_number(const Cell& cell) {
  return std::holds_alternative<Number>(cell) || std::holds_alternative<long>(cell);
}

/// For each column, whether it has a number.
std::vector<bool> columns_with_numbers(const Table& table) {
  std::vector<bool> has_numbers(table.columns.size());
  for (const auto& row : table.rows)
    for (std::size_t i = 0; i < row.size(); ++i) has_numbers[i] = has_numbers[i] || is_number(row[i]);
  return has_numbers;
}

/// ` class="..."` of a cell with these words; otherwise empty. Long texts get a wide column.
std::string class_of_cell(std::string_view words, bool in_a_column_of_numbers) {
  constexpr std::size_t most_in_a_narrow_column = 24;
  if (words.size() > most_in_a_narrow_column)
    return fmt::format(" class=\"{}{}long\"", class_of_verdict(words),
                       class_of_verdict(words).empty() ? "" : " ");
  const std::string_view name = in_a_column_of_numbers ? "number" : class_of_verdict(words);
  return name.empty() ? "" : fmt::format(" class=\"{}\"", name);
}

}  // namespace

std::string html_page(const OthersText& title, std::string_view body) {
  return fmt::format(
      "<!doctype html><!-- shadefit -->\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{}</title>\n"
      "<link rel=\"icon\" href=\"data:,\">\n<style>\n{}</style>\n</head>\n<body>\n{}<script>\n{}</script>\n</body>\n</html>\n",
      for_html(title), embedded_text(page_files, "style"), body, embedded_text(page_files, "script"));
}

std::string html_table(const Table& table, bool is_index) {
  std::string out = fmt::format(
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"table\"><table{}>\n<thead><tr>",
      is_index ? " class=\"sortable\"" : "");
  const std::vector<bool> has_numbers = columns_with_numbers(table);
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const std::string name = for_html(table.columns[i]);
    out += fmt::format("<th scope=\"col\"{}{}>{}</th>", has_numbers[i] ? " class=\"number\"" : "",
                       is_index ? " aria-sort=\"none\"" : "",
                       is_index ? "<button type=\"button\">" + name + "</button>" : name);
  }
  out += "</tr></thead>\n<tbody>\n";
  for (const auto& row : table.rows) {
    out += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      const auto* others = std::get_if<OthersText>(&row[i]);
      const std::string words = for_html(others != nullptr ? *others : text(row[i], Precision::report));
      const std::string inside =
          is_index && i == 0 ? fmt::format("<a href=\"{0}.html\">{0}</a>", words) : words;
      out += fmt::format("<td{}>{}</td>", class_of_cell(words, has_numbers[i]), inside);
    }
    out += "</tr>\n";
  }
  return out + "</tbody></table></div>\n";
}

}  // namespace shadefit
