#pragma once

#include <string>
#include <string_view>

#include "reports/table/table.hpp"

/// Pages without a framework and without a network.
namespace shadefit {

/// A text with the signs of HTML escaped.
std::string html_text(std::string_view text);

/// A whole page: its style and its script stand in it. `body` is HTML.
std::string html_page(std::string_view title, std::string_view body);

/// A table with a header; numbers are right-aligned, verdicts coloured. In an index a click on a header
/// sorts, by value where the column has numbers, and the first cell X of a row leads to X.html.
std::string html_table(const Table& table, bool is_index);

}  // namespace shadefit
