#pragma once

#include <string>
#include <string_view>

#include "reports/table/table.hpp"

/// Pages without a framework and without a network.
namespace shadefit {

/// A text with the special characters of HTML escaped.
std::string html_text(std::string_view text);

/// A whole page, with its style and its script inside. `body` is HTML.
std::string html_page(std::string_view title, std::string_view body);

/// A table with a header; numbers are right-aligned, verdicts coloured. In an index a click on a header
/// sorts, by value if the column has numbers, and the first cell X of a row links to X.html.
std::string html_table(const Table& table, bool is_index);

}  // namespace shadefit
