#include "reports/io/escape.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "reports/io/joined.hpp"
#include "reports/io/utf8.hpp"

namespace shadefit {
namespace {

/// A character and what stands for it.
using Escape = std::pair<char, std::string_view>;

/// The text with the characters of `escapes` replaced, and a backslash before those of `marked`.
template <std::size_t N>
std::string with_escapes(std::string_view text, const std::array<Escape, N>& escapes,
                         std::string_view marked = "") {
  return joined(text, "", [&](char c) {
    const auto* found = std::ranges::find(escapes, c, &Escape::first);
    if (found != escapes.end()) return std::string(found->second);
    return marked.find(c) == marked.npos ? std::string(1, c) : std::string{'\\', c};
  });
}

constexpr std::array<Escape, 4> html_escapes{{{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}}};

/// References where GitHub reads more than CommonMark: rows of tables, mathematics and mentions.
constexpr std::array<Escape, 6> markdown_escapes{
    {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'|', "&#124;"}, {'$', "&#36;"}, {'@', "&#64;"}}};

/// The default font encoding lacks <, > and | in text. BibTeX counts a brace also behind a backslash.
constexpr std::array<Escape, 8> latex_escapes{{{'\\', "\\textbackslash{}"},
                                               {'~', "\\textasciitilde{}"},
                                               {'^', "\\textasciicircum{}"},
                                               {'<', "\\textless{}"},
                                               {'>', "\\textgreater{}"},
                                               {'|', "\\textbar{}"},
                                               {'{', "\\textbraceleft{}"},
                                               {'}', "\\textbraceright{}"}}};

}  // namespace

std::string for_terminal(const OthersText& text) {
  return printable(text.unescaped());
}

std::string for_markdown(const OthersText& text) {
  constexpr std::string_view digits = "0123456789";
  std::string out = with_escapes(for_terminal(text), markdown_escapes, R"(\`*_[]#~)");
  // GitHub turns text that looks like an address into a link.
  for (const std::string_view sign : {"://", "www."}) {
    for (std::size_t i = 0; (i = out.find(sign, i)) != std::string::npos; i += sign.size())
      out.replace(i + (sign == "www." ? 3 : 0), 1, sign == "www." ? "&#46;" : "&#58;");
  }
  // At the start of a line stand items of lists, underlines of headings and, indented, code.
  out.erase(0, out.find_first_not_of(' '));
  const std::size_t sign = std::min(out.find_first_not_of(digits), out.size());
  const std::string_view rest = std::string_view(out).substr(sign), next = rest.substr(0, 2);
  const bool is_item = sign == 0 ? next.find_first_of("-+=") == 0 && next.find_first_of(digits) != 1
                                 : next == "." || next == ")" || next == ". " || next == ") ";
  return is_item ? out.insert(sign, "\\") : out;
}

std::string for_html(const OthersText& text) {
  return with_escapes(for_terminal(text), html_escapes);
}

std::string for_latex(const OthersText& text) {
  return with_escapes(for_terminal(text), latex_escapes, "&%$#_");
}

std::string for_gnuplot(const OthersText& text) {
  return with_escapes(for_terminal(text), std::array<Escape, 0>{}, R"(\^_{}@&~)");
}

std::string gnuplot_quoted(std::string_view text) {
  return "'" + with_escapes(text, std::array<Escape, 1>{{{'\'', R"('."\047".')"}}}) + "'";
}

std::string for_comment(const OthersText& text) {
  std::string out = for_terminal(text);
  out.erase(out.find_last_not_of(' ') + 1);
  // A backslash at the end, or its trigraph, takes the next line into the comment.
  return out.ends_with('\\') || out.ends_with(
                                    "?"
                                    "?/")
             ? out + "."
             : out;
}

std::string for_csv(const OthersText& text) {
  const std::string out = for_terminal(text);
  const bool is_computed =
      !out.empty() && std::string_view("=+-@").find(out.front()) != std::string_view::npos;
  return is_computed ? "'" + out : out;
}

std::string json_text(const nlohmann::ordered_json& json) {
  constexpr bool is_ascii = true;
  return json.dump(2, ' ', is_ascii, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace shadefit
