#include "lint/scan/literals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>

#include "lint/scan/characters.hpp"
#include "lint/scan/notation.hpp"

namespace shadefit::lint {
namespace {

/// Without leading zeros.
std::uint32_t count_significant(const Notation& number) {
  std::uint32_t count = 0;
  for (const std::string_view digits : {number.whole, number.fraction})
    for (const char c : digits)
      if (is_digit(c) && (c != '0' || count > 0)) ++count;
  return count;
}

struct Quote {
  std::size_t end = 0;  ///< of its content
  /// Whether it may have several lines, as a shader in a template of JavaScript has. Such a text may have
  /// comments of its own.
  bool has_lines = false;
};

/// Finds the quotes of a text, which hide the signs of comments.
class QuoteFinder {
 public:
  QuoteFinder(std::string_view text, CommentStyle style) : text_(text), style_(style) {}

  /// The quote that begins at this byte, outside of comments and of other quotes. A quote without an end does
  /// not count: it may be an apostrophe.
  std::optional<Quote> at(std::size_t begin) {
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

 private:
  char before(std::size_t at) const { return at > 0 ? text_[at - 1] : '\0'; }
  char behind(std::size_t at) const { return at + 1 < text_.size() ? text_[at + 1] : '\0'; }

  std::optional<Quote> double_quote(std::size_t begin) {
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
  std::optional<Quote> raw_text(std::size_t begin) {
    constexpr std::size_t most_bytes_of_mark = 16;
    const char prefix = begin > 0 ? before(begin - 1) : '\0';  // u8R, LR, but not PTR
    const bool is_raw = before(begin) == 'R' && (!is_of_name(prefix) || prefix == '8' || prefix == 'L');
    if (style_ == CommentStyle::c && is_raw) {
      const std::size_t open = text_.substr(begin, most_bytes_of_mark + 2).find('(');
      if (open == std::string_view::npos) return std::nullopt;
      return until(begin + open + 1, fmt::format("){}\"", text_.substr(begin + 1, open - 1)), false);
    }
    if (style_ != CommentStyle::rust) return std::nullopt;
    std::size_t marks = 0;
    while (marks < most_bytes_of_mark && marks < begin && text_[begin - marks - 1] == '#') ++marks;
    if (before(begin - marks) != 'r') return std::nullopt;
    return until(begin + 1, "\"" + std::string(marks, '#'), false);
  }

  std::optional<Quote> apostrophe(std::size_t begin) {
    // A lifetime of Rust has no second one: &'a str.
    if (style_ == CommentStyle::rust) {
      const bool is_character = behind(begin) == '\\' || behind(begin + 1) == '\'';
      return is_character ? in_line(begin) : std::nullopt;
    }
    // In 0xFF'FF it separates digits, in "don't" it is a letter. u8'x' and rb'x' have a prefix.
    constexpr std::string_view prefixes = "LuU8bBrRfF";
    std::size_t letters = 0;
    while (letters <= 2 && letters < begin && is_of_name(text_[begin - letters - 1])) ++letters;
    if (letters > 2 || (letters > 0 && !is_one_of(before(begin), prefixes))) return std::nullopt;
    constexpr std::string_view three = "'''";
    if (style_ == CommentStyle::hash && text_.substr(begin).starts_with(three))
      return until(begin + three.size(), three, true);
    return in_line(begin);
  }

  /// A regular expression of JavaScript: a slash where an operand is expected.
  std::optional<Quote> pattern(std::size_t begin) const {
    constexpr std::size_t longest = 200;
    if (behind(begin) == '/' || behind(begin) == '*') return std::nullopt;
    const std::size_t last = begin_of_run(text_, begin, is_blank);
    if (last == 0 || !is_one_of(text_[last - 1], "(,=:[!&|?{;")) return std::nullopt;
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
  std::optional<Quote> in_line(std::size_t begin) const {
    for (std::size_t i = begin + 1; i < text_.size() && text_[i] != '\n'; ++i) {
      if (text_[i] == text_[begin]) return Quote{i, false};
      if (text_[i] == '\\') ++i;
    }
    return std::nullopt;
  }

  /// A quote of several lines.
  std::optional<Quote> until(std::size_t first, std::string_view closing, bool has_escapes) {
    if (is_one_open_) return std::nullopt;
    for (std::size_t i = first; i < text_.size(); ++i) {
      if (text_[i] == closing.front() && text_.substr(i).starts_with(closing)) return Quote{i, true};
      if (has_escapes && text_[i] == '\\') ++i;
    }
    is_one_open_ = true;
    return std::nullopt;
  }

  std::string_view text_;
  CommentStyle style_;
  /// Whether the end of a long quote was not found: the next ones are not trusted.
  bool is_one_open_ = false;
};

/// Scans a text for numbers.
class LiteralReader {
 public:
  /// `code`: the text, in which comments become blanks; or nothing.
  LiteralReader(std::string_view text, CommentStyle style, std::string* code)
      : text_(text), style_(style), quotes_(text, style), code_(code) {}

  std::vector<Literal> read() {
    while (at_ < text_.size()) {
      const std::size_t first = at_;
      const bool was_long = comment_ == '*';
      const char c = text_[at_];
      if (is_digit(c) || (c == '.' && is_digit(peek(1)))) {
        number();
      } else if (is_of_name(c)) {
        word();
      } else {
        if (style_ != CommentStyle::none) quote_or_comment();
        ++at_;
      }
      // The last sign of a long comment has closed it, and is a part of it.
      if (code_ != nullptr && (comment_ != '\0' || (was_long && c == '*'))) blank(first);
    }
    return std::move(literals_);
  }

 private:
  char peek(std::size_t ahead) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

  void blank(std::size_t first) {
    for (std::size_t i = first; i < at_; ++i)
      if (!is_blank((*code_)[i])) (*code_)[i] = ' ';
  }

  void word() {
    // One letter follows a backslash: "\n0.055" in a string holds a number.
    if (at_ > 0 && text_[at_ - 1] == '\\') {
      ++at_;
      return;
    }
    at_ = end_of_run(text_, at_, is_of_name);
  }

  /// A quote hides the signs of comments: glob("src/*.glsl") opens no comment. A quote of several lines may
  /// hold a shader. Its comments end where the quote ends.
  void quote_or_comment() {
    if (quote_ && at_ >= quote_->end) {
      const bool is_closing = at_ == quote_->end;
      quote_.reset();
      comment_ = '\0';
      if (is_closing) return;
    }
    if (quote_) {
      if (quote_->has_lines && has_slashes(style_)) comment();
      return;
    }
    if (comment_ == '\0') quote_ = quotes_.at(at_);
    if (!quote_) comment();
  }

  void comment() {
    const char c = text_[at_];
    if (c == '\n' && comment_ == '/') comment_ = '\0';
    if (comment_ == '*' && c == '*' && peek(1) == '/') {
      comment_ = '\0';
      ++at_;
    }
    if (comment_ != '\0') return;
    if (style_ == CommentStyle::hash) {
      if (begins_hash_comment(text_, at_)) comment_ = '/';
    } else if (c == '/' && peek(1) == '/') {
      // "https://" is not a comment.
      if (at_ == 0 || text_[at_ - 1] != ':') comment_ = '/';
      ++at_;
    } else if (c == '/' && peek(1) == '*') {
      comment_ = '*';
      ++at_;
    }
  }

  /// Whether a factor 10^n follows, in LaTeX or plain text.
  bool is_before_power_of_ten() const {
    std::string_view rest = text_.substr(at_, 20);
    while (rest.starts_with(' ')) rest.remove_prefix(1);
    for (const std::string_view sign : {"\\times", "\\cdot", "\xc3\x97", "x", "*"}) {
      if (!rest.starts_with(sign)) continue;
      rest.remove_prefix(sign.size());
      while (rest.starts_with(' ')) rest.remove_prefix(1);
      return rest.starts_with("10^") || rest.starts_with("10**");
    }
    return false;
  }

  void number() {
    const std::size_t first = at_;
    const Notation number = parts_of_number(text_.substr(first));
    at_ += number.length;
    // 1.2.3 is a version.
    const bool is_version = peek(0) == '.' && is_digit(peek(1));
    while (peek(0) == '.' && is_digit(peek(1))) at_ = end_of_run(text_, at_ + 1, is_digit);
    const std::size_t length = at_ - first;
    const std::uint32_t significant = count_significant(number);
    if (is_suffix(number.suffix) && !is_version && significant > 0 && length <= most_digits)
      literals_.push_back({first, length, significant, comment_ != '\0', is_before_power_of_ten(),
                           digits_of(text_.substr(first, length))});
  }

  std::string_view text_;
  CommentStyle style_;
  std::size_t at_ = 0;
  QuoteFinder quotes_;
  std::optional<Quote> quote_;
  std::string* code_;
  char comment_ = '\0';  ///< '/' to the end of the line, '*' to its mark
  std::vector<Literal> literals_;
};

}  // namespace

bool begins_hash_comment(std::string_view text, std::size_t at) {
  if (text[at] != '#') return false;
  const std::size_t first = begin_of_run(text, at, is_blank_in_line);
  if (first > 0 && text[first - 1] != '\n') return true;
  const std::string_view rest = text.substr(at + 1);
  return !(rest.starts_with("define ") || rest.starts_with("version ") || rest.starts_with("include "));
}

Digits digits_of(std::string_view number) {
  Digits result;
  int point = 0;
  bool has_point = false;
  std::size_t i = 0;
  for (; i < number.size(); ++i) {
    const char c = number[i];
    if (c == '.') {
      has_point = true;
    } else if (is_digit(c)) {
      if (c != '0' || !result.text.empty()) {
        result.text += c;
        if (!has_point) ++point;
      } else if (has_point) {
        --point;
      }
    } else if (c == 'e' || c == 'E') {
      if (i + 1 < number.size() && number[i + 1] == '+') ++i;
      int exponent = 0;
      std::from_chars(number.data() + i + 1, number.data() + number.size(), exponent);
      // No number of a source text has a larger exponent; a sum with it does not overflow.
      point += std::clamp(exponent, -100'000, 100'000);
      break;
    } else if (is_letter(c)) {
      break;
    }
  }
  while (!result.text.empty() && result.text.back() == '0') {
    result.text.pop_back();
    if (has_point) ++result.last_zeros;
  }
  result.exponent = result.text.empty() ? 0 : point;
  return result;
}

std::vector<Literal> literals_of(std::string_view text, CommentStyle style) {
  return LiteralReader(text, style, nullptr).read();
}

std::string with_blank_comments(std::string_view text, CommentStyle style) {
  std::string code(text);
  LiteralReader(text, style, &code).read();
  return code;
}

}  // namespace shadefit::lint
