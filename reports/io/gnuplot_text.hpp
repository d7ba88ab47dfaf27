#pragma once

#include <string>
#include <string_view>

/// Texts in a script for gnuplot.
namespace shadefit {

/// A text as gnuplot's expression for it. In single quotes only the quote is special. gnuplot 5.4 misreads
/// two quotes at the start or in the middle, so each quote becomes a separate string.
inline std::string gnuplot_quoted(std::string_view text) {
  std::string quoted = "'";
  for (const char letter : text) {
    if (letter == '\'') {
      quoted += R"('."\047".')";
    } else {
      quoted += letter;
    }
  }
  return quoted + "'";
}

/// A text that gnuplot's enhanced text shows unchanged.
inline std::string gnuplot_unmarked(std::string_view text) {
  constexpr std::string_view markup = R"(\^_{}@&~)";
  std::string unmarked;
  for (const char letter : text) {
    if (markup.find(letter) != markup.npos) unmarked += '\\';
    unmarked += letter;
  }
  return unmarked;
}

}  // namespace shadefit
