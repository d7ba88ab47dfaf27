#include "lint/scan/quotes.hpp"

#include <algorithm>
#include <string>

#include "lint/scan/characters.hpp"

namespace shadefit::lint {

std::optional<Quote> QuoteFinder::at(std::size_t begin) {
  switch (text_[begin]) {
    case '"':
      return double_quote(begin);
    case '\'':
      return apostrophe(begin);
    case '`':
      return style_ == CommentStyle::c ? until(begin + 1, "`", true) : std::nullopt;
    case '/':
      return style_ == CommentStyle::c ? pattern(begin) : std::nullopt;
    default:
      return std::nullopt;
  }
}

std::optional<Quote> QuoteFinder::double_quote(std::size_t begin) {
  // Text blocks of Java and C#, and long strings of Python.
  constexpr std::string_view three = R"(""")";
  if (text_.substr(begin).starts_with(three)) return until(begin + three.size(), three, true);
  if (style_ != CommentStyle::hash)
    if (const auto raw = raw_text(begin)) return raw;
  // A string of Rust and a verbatim one of C# may have several lines.
  if (style_ == CommentStyle::rust) return until(begin + 1, "\"", true);
  if (style_ == CommentStyle::c && before(begin) == '@') return until(begin + 1, "\"", false);
  return in_line(begin);
}

/// R"x( .. )x" of C++ and r#" .. "# of Rust.
std::optional<Quote> QuoteFinder::raw_text(std::size_t begin) {
  constexpr std::size_t most_bytes_of_mark = 16;
  const char prefix = begin > 0 ? before(begin - 1) : '\0';  // u8R, LR, but not PTR
  const bool is_raw = before(begin) == 'R' && (!is_of_name(prefix) || prefix == '8' || prefix == 'L');
  if (style_ == CommentStyle::c && is_raw) {
    const std::size_t open = text_.substr(begin, most_bytes_of_mark + 2).find('(');
    if (open == std::string_view::npos) return std::nullopt;
    const std::string mark(text_.substr(begin + 1, open - 1));
    return until(begin + open + 1, ")" + mark + "\"", false);
  }
  if (style_ != CommentStyle::rust) return std::nullopt;
  std::size_t marks = 0;
  while (marks < most_bytes_of_mark && marks < begin && text_[begin - marks - 1] == '#') ++marks;
  if (before(begin - marks) != 'r') return std::nullopt;
  return until(begin + 1, "\"" + std::string(marks, '#'), false);
}

std::optional<Quote> QuoteFinder::apostrophe(std::size_t begin) {
  // A lifetime of Rust has no second one: &'a str.
  if (style_ == CommentStyle::rust) {
    const bool is_character = behind(begin) == '\\' || behind(begin + 1) == '\'';
    return is_character ? in_line(begin) : std::nullopt;
  }
  // In 0xFF'FF it separates digits, in "don't" it is a letter. u8'x' and rb'x' have a prefix.
  constexpr std::string_view prefixes = "LuU8bBrRfF";
  std::size_t letters = 0;
  while (letters <= 2 && letters < begin && is_of_name(text_[begin - letters - 1])) ++letters;
  if (letters > 2 || (letters > 0 && prefixes.find(before(begin)) == std::string_view::npos))
    return std::nullopt;
  constexpr std::string_view three = "'''";
  if (style_ == CommentStyle::hash && text_.substr(begin).starts_with(three))
    return until(begin + three.size(), three, true);
  return in_line(begin);
}

/// A regular expression of JavaScript: a slash where an operand is expected.
std::optional<Quote> QuoteFinder::pattern(std::size_t begin) const {
  constexpr std::size_t longest = 200;
  if (behind(begin) == '/' || behind(begin) == '*') return std::nullopt;
  std::size_t last = begin;
  while (last > 0 && is_blank(text_[last - 1])) --last;
  if (last == 0 || std::string_view("(,=:[!&|?{;").find(text_[last - 1]) == std::string_view::npos)
    return std::nullopt;
  bool is_in_set = false;
  const std::size_t most = std::min(text_.size(), begin + longest);
  for (std::size_t i = begin + 1; i < most && text_[i] != '\n'; ++i) {
    if (text_[i] == '\\') {
      ++i;
    } else if (text_[i] == '[' || text_[i] == ']') {
      is_in_set = text_[i] == '[';
    } else if (text_[i] == '/' && !is_in_set) {
      return Quote{i, false};
    }
  }
  return std::nullopt;
}

/// A quote that ends in its line, or in the next one behind a backslash.
std::optional<Quote> QuoteFinder::in_line(std::size_t begin) const {
  for (std::size_t i = begin + 1; i < text_.size() && text_[i] != '\n'; ++i) {
    if (text_[i] == text_[begin]) return Quote{i, false};
    if (text_[i] == '\\') ++i;
  }
  return std::nullopt;
}

/// A quote of several lines.
std::optional<Quote> QuoteFinder::until(std::size_t first, std::string_view closing, bool has_escapes) {
  if (is_one_open_) return std::nullopt;
  for (std::size_t i = first; i < text_.size(); ++i) {
    if (text_[i] == closing.front() && text_.substr(i).starts_with(closing)) return Quote{i, true};
    if (has_escapes && text_[i] == '\\') ++i;
  }
  is_one_open_ = true;
  return std::nullopt;
}

}  // namespace shadefit::lint
