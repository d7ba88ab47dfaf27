#include "lint/expression/comment_text.hpp"

#include "lint/scan/characters.hpp"

namespace shadefit::lint {
namespace {

/// The signs of comments as blanks; a semicolon ends the code before them.
std::string without_comment_signs(std::string_view text) {
  std::string out(text);
  bool is_at_start = true;  // of a line, or of a comment
  for (std::size_t i = 0; i < out.size(); ++i) {
    const std::string_view sign = text.substr(i, 2);
    if (out[i] == '\n') {
      is_at_start = true;
    } else if (sign == "//" || sign == "/*" || sign == "*/") {
      out[i] = ';';
      out[++i] = ' ';
      is_at_start = true;
    } else if (is_at_start && std::string_view("*/#!<").find(out[i]) != std::string_view::npos) {
      out[i] = ' ';
    } else if (!is_blank(out[i])) {
      is_at_start = false;
    }
  }
  return out;
}

}  // namespace

std::string comment_as_program(std::string_view text) {
  std::string out = without_comment_signs(text);
  for (std::size_t i = 1; i + 1 < out.size(); ++i) {
    const char last = out[i - 1];
    // "acos: a x" and "by a x. The next"
    if ((out[i] == ':' || out[i] == '.') && is_of_name(last) && is_blank(out[i + 1])) out[i] = ';';
    if ((out[i] != ' ' && out[i] != '\t') || !(is_of_name(last) || last == ')')) continue;
    std::size_t next = i;
    while (next < out.size() && (out[next] == ' ' || out[next] == '\t')) ++next;
    if (next < out.size() && is_of_name(out[next])) out[i] = ';';
  }
  return out;
}

}  // namespace shadefit::lint
