#pragma once

#include <string>
#include <string_view>

#include "reports/io/joined.hpp"

/// Texts in a script for gnuplot.
namespace shadefit {

/// A text as gnuplot's expression for it. In single quotes only the quote is special. gnuplot 5.4 misreads
/// two quotes at the start or in the middle, so each quote becomes a separate string.
inline std::string gnuplot_quoted(std::string_view text) {
  const auto part = [](char c) { return c == '\'' ? std::string(R"('."\047".')") : std::string(1, c); };
  return "'" + joined(text, "", part) + "'";
}

}  // namespace shadefit
