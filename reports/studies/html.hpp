#pragma once

#include <string>
#include <string_view>

#include "reports/io/table.hpp"

/// Pages without a framework and without a network.
namespace shadefit {

/// A whole page, with its style and its script inside. `body` is HTML.
std::string html_page(const OthersText& title, std::string_view body);

/// A table with a header; numbers are right-aligned, verdicts coloured. In an index a click on a header
/// sorts, by value if the column has numbers, and the first cell X of a row links to X.html.
std::string html_table(const Table& table, bool is_index);

}  // namespace shadefit
