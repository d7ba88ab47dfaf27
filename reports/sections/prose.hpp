#pragma once

#include <string>
#include <string_view>
#include <vector>

/// The words of a report: sentences, lines, headings.
namespace shadefit {

/// The text of reports/sections/text/NAME.md, and an empty line.
std::string section_text(std::string_view name);

/// The sentences of a text. A full stop and a space end one; the two points of ".. " do not.
std::vector<std::string> sentences_of(std::string_view text);

/// A Markdown text with one sentence per line. Lists keep their indentation; tables and headings are
/// unchanged. A sentence over 400 letters is also broken at its semicolons, or at its colons if it has none.
std::string with_short_lines(std::string_view markdown);

/// GitHub's anchor of a heading: "Exact Fresnel (`a`)" gives "exact-fresnel-a".
std::string anchor(std::string_view heading);

/// A list of links to the headings of a Markdown text, of the second and third level.
std::string contents(std::string_view markdown);

}  // namespace shadefit
