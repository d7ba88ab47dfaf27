#include "lint/expression/program_text.hpp"

#include <optional>
#include <vector>

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
    } else if (is_at_start && is_one_of(out[i], "*/#!<")) {
      out[i] = ' ';
    } else if (!is_blank(out[i])) {
      is_at_start = false;
    }
  }
  return out;
}

/// Where this quote stands in a text, unless it is escaped.
std::vector<std::size_t> quotes_in(std::string_view text, char quote) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\\')
      ++i;
    else if (text[i] == quote)
      places.push_back(i);
  }
  return places;
}

/// Whether this is a quote, and each one of the text has its partner there.
bool is_in_pairs(char quote, std::string_view text) {
  return (quote == '"' || quote == '\'') && quotes_in(text, quote).size() % 2 == 0;
}

/// The quote at the end of a line, perhaps before a sign that joins it to the next one.
std::optional<std::size_t> last_quote(std::string_view line) {
  std::size_t end = begin_of_run(line, line.size(), is_blank);
  if (end > 0 && (line[end - 1] == '+' || line[end - 1] == '\\')) --end;
  end = begin_of_run(line, end, is_blank);
  if (end == 0 || !is_in_pairs(line[end - 1], line.substr(0, end))) return std::nullopt;
  return end - 1;
}

/// The quote at the start of a line, perhaps behind a sign that joins it to the line before.
std::optional<std::size_t> first_quote(std::string_view line) {
  std::size_t begin = end_of_run(line, 0, is_blank);
  if (begin < line.size() && line[begin] == '+') ++begin;
  begin = end_of_run(line, begin, is_blank);
  if (begin == line.size() || !is_in_pairs(line[begin], line.substr(begin))) return std::nullopt;
  return begin;
}

/// Replaces a closing quote, and the escaped ends of lines before it.
void close(std::string& out, std::size_t quote, char sign) {
  out[quote] = sign;
  while (quote >= 2 && out[quote - 2] == '\\' && (out[quote - 1] == 'n' || out[quote - 1] == 'r')) {
    out[quote - 2] = out[quote - 1] = ' ';
    quote -= 2;
  }
}

/// Replaces what stands between two strings by blanks, except the ends of lines.
void join(std::string& out, std::size_t closing, std::size_t opening) {
  for (std::size_t i = closing; i <= opening; ++i)
    if (out[i] != '\n') out[i] = ' ';
  close(out, closing, ' ');
}

}  // namespace

std::string comment_as_program(std::string_view text) {
  std::string out = without_comment_signs(text);
  for (std::size_t i = 1; i + 1 < out.size(); ++i) {
    const char last = out[i - 1];
    // "acos: a x" and "by a x. The next"
    if ((out[i] == ':' || out[i] == '.') && is_of_name(last) && is_blank(out[i + 1])) out[i] = ';';
    if (!is_blank_in_line(out[i]) || !(is_of_name(last) || last == ')')) continue;
    const std::size_t next = end_of_run(out, i, is_blank_in_line);
    if (next < out.size() && is_of_name(out[next])) out[i] = ';';
  }
  return out;
}

std::string with_joined_strings(std::string_view text, CommentStyle style) {
  std::string out(text);
  if (style != CommentStyle::c && style != CommentStyle::hash) return out;
  bool is_joined = false;  // the line before to this one
  for (std::size_t begin = 0, next = 0; begin < text.size(); begin = next) {
    const std::string_view line = line_at(text, begin);
    next = begin + line.size() + 1;
    const auto closing = last_quote(line);
    const auto opening = closing && next < text.size() ? first_quote(line_at(text, next)) : std::nullopt;
    const bool joins = opening && text[next + *opening] == line[*closing];
    if (joins) {
      // The last string of the line begins the program.
      const auto before = quotes_in(line.substr(0, *closing), line[*closing]);
      if (!is_joined) out[begin + (before.empty() ? *closing : before.back())] = ';';
      join(out, begin + *closing, next + *opening);
    } else if (is_joined) {
      const std::size_t first = *first_quote(line);
      const auto behind = quotes_in(line.substr(first + 1), line[first]);
      if (!behind.empty()) close(out, begin + first + 1 + behind.front(), ';');
    }
    is_joined = joins;
  }
  return out;
}

}  // namespace shadefit::lint
