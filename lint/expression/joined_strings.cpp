#include "lint/expression/joined_strings.hpp"

#include <algorithm>
#include <optional>

#include "lint/scan/characters.hpp"

namespace shadefit::lint {
namespace {

bool is_quote(char c) {
  return c == '"' || c == '\'';
}

/// The bytes of a line without its end.
struct LineRange {
  std::size_t begin, end;
};

/// Whether each of these quotes in the line has its partner there.
bool has_pairs(std::string_view line, char quote) {
  bool is_open = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '\\')
      ++i;
    else if (line[i] == quote)
      is_open = !is_open;
  }
  return !is_open;
}

/// The quote at the end of a line, perhaps before a sign that joins it to the next one.
std::optional<std::size_t> last_quote(std::string_view text, LineRange line) {
  std::size_t end = line.end;
  const auto skip_blanks = [&] {
    while (end > line.begin && is_blank(text[end - 1])) --end;
  };
  skip_blanks();
  if (end > line.begin && (text[end - 1] == '+' || text[end - 1] == '\\')) --end;
  skip_blanks();
  if (end == line.begin || !is_quote(text[end - 1])) return std::nullopt;
  if (!has_pairs(text.substr(line.begin, end - line.begin), text[end - 1])) return std::nullopt;
  return end - 1;
}

/// The quote at the start of a line, perhaps behind a sign that joins it to the line before.
std::optional<std::size_t> first_quote(std::string_view text, LineRange line) {
  std::size_t begin = line.begin;
  const auto skip_blanks = [&] {
    while (begin < line.end && is_blank(text[begin])) ++begin;
  };
  skip_blanks();
  if (begin < line.end && text[begin] == '+') ++begin;
  skip_blanks();
  if (begin == line.end || !is_quote(text[begin])) return std::nullopt;
  if (!has_pairs(text.substr(begin, line.end - begin), text[begin])) return std::nullopt;
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

/// Replaces the quote that opens the last string of a line, whose closing quote is given.
void open(std::string& out, std::size_t closing, std::size_t line) {
  std::size_t last = closing;
  for (std::size_t i = line; i < closing; ++i) {
    if (out[i] == '\\')
      ++i;
    else if (out[i] == out[closing])
      last = i;
  }
  out[last] = ';';
}

/// The quote that closes the string which begins a line.
std::size_t closing_quote(std::string_view text, std::size_t opening) {
  std::size_t i = opening + 1;
  while (i < text.size() && text[i] != text[opening]) i += text[i] == '\\' ? 2 : 1;
  return i;
}

}  // namespace

std::string with_joined_strings(std::string_view text, CommentStyle style) {
  std::string out(text);
  if (style != CommentStyle::c && style != CommentStyle::hash) return out;
  bool is_joined = false;  // the line before to this one
  for (std::size_t begin = 0; begin < text.size();) {
    const LineRange line{begin, std::min(text.find('\n', begin), text.size())};
    const std::size_t next = line.end + 1;
    begin = next;
    const auto closing = last_quote(text, line);
    const auto opening = closing && next < text.size()
                             ? first_quote(text, {next, std::min(text.find('\n', next), text.size())})
                             : std::nullopt;
    const bool joins = opening && text[*opening] == text[*closing];
    if (joins) {
      if (!is_joined) open(out, *closing, line.begin);
      join(out, *closing, *opening);
    } else if (is_joined) {
      const std::size_t last = closing_quote(text, *first_quote(text, line));
      if (last < line.end) close(out, last, ';');
    }
    is_joined = joins;
  }
  return out;
}

}  // namespace shadefit::lint
