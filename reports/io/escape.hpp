#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "fit/support/others_text.hpp"

/// Text of others, escaped for its place: there it reads as it is, and says nothing else. In each place it is
/// one line, in which a character that `is_unshown` (reports/io/utf8.hpp) is \xNN for each of its bytes.
namespace shadefit {

/// For a terminal.
std::string for_terminal(const OthersText& text);

/// For a paragraph or a cell of Markdown, as GitHub reads it: no markup, link, HTML, mathematics or mention.
std::string for_markdown(const OthersText& text);

/// For an element or an attribute in double quotes of HTML.
std::string for_html(const OthersText& text);

/// For words of LaTeX, or a field of BibTeX in braces. Other UTF-8 is left as it is.
std::string for_latex(const OthersText& text);

/// For gnuplot's enhanced text, which still has to be quoted.
std::string for_gnuplot(const OthersText& text);

/// A text as gnuplot's expression for it. In single quotes only the quote is special. gnuplot 5.4 misreads
/// two quotes at the start or in the middle, so each quote becomes a separate string.
std::string gnuplot_quoted(std::string_view text);

/// For a comment to the end of a line: of gnuplot, and of each language of `emit`.
std::string for_comment(const OthersText& text);

/// For a cell of CSV, which still has to be quoted. A spreadsheet would compute a text that begins with an
/// operator, so a ' stands before it (OWASP, CSV Injection).
std::string for_csv(const OthersText& text);

/// A JSON value as a file or a reader gets it, in ASCII. What is no UTF-8 becomes U+FFFD.
std::string json_text(const nlohmann::ordered_json& json);

}  // namespace shadefit
