#include "lint/scan/literals.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>

#include "lint/scan/characters.hpp"
#include "lint/scan/notation.hpp"

namespace shadefit::lint {
namespace {

/// Whether # begins a comment here. In Python # begins one, but #define is a line of a shader.
bool begins_hash_comment(std::string_view text, std::size_t at) {
  if (text[at] != '#') return false;
  const std::size_t first = begin_of_run(text, at, is_blank_in_line);
  if (first > 0 && text[first - 1] != '\n') return true;
  const std::string_view rest = text.substr(at + 1);
  return !(rest.starts_with("define ") || rest.starts_with("version ") || rest.starts_with("include "));
}

/// Where the quote ends that begins at this byte, outside of comments and of other quotes: in its line, or in
/// the next one behind a backslash. Quotes hide the signs of comments. Empty for another byte, and for an
/// apostrophe.
std::optional<std::size_t> quote_end(std::string_view text, std::size_t begin, CommentStyle style) {
  if (text[begin] != '"' && text[begin] != '\'') return std::nullopt;
  if (text[begin] == '\'') {
    // In 0xFF'FF it separates digits, in "don't" it is a letter. A lifetime of Rust has no second one: &'a
    // str.
    if (begin > 0 && is_of_name(text[begin - 1])) return std::nullopt;
    if (style == CommentStyle::rust && text.substr(begin + 1, 1) != "\\" && text.substr(begin + 2, 1) != "'")
      return std::nullopt;
  }
  for (std::size_t i = begin + 1; i < text.size() && text[i] != '\n'; ++i) {
    if (text[i] == text[begin]) return i;
    if (text[i] == '\\') ++i;
  }
  return std::nullopt;
}

/// Scans a text for numbers.
class LiteralReader {
 public:
  /// `code`: the text, in which comments become blanks; or nothing.
  LiteralReader(std::string_view text, CommentStyle style, std::string* code)
      : text_(text), style_(style), code_(code) {}

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
      if (code_ != nullptr && (comment_ != '\0' || (was_long && c == '*')))
        for (std::size_t i = first; i < at_; ++i)
          if (!is_blank((*code_)[i])) (*code_)[i] = ' ';
    }
    return std::move(literals_);
  }

 private:
  char peek(std::size_t ahead) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }

  void word() {
    // One letter follows a backslash: "\n0.055" in a string holds a number.
    if (at_ > 0 && text_[at_ - 1] == '\\') {
      ++at_;
      return;
    }
    at_ = end_of_run(text_, at_, is_of_name);
  }

  /// A quote hides the signs of comments: glob("src/*.glsl") opens no comment.
  void quote_or_comment() {
    if (quote_end_ && at_ >= *quote_end_) {
      quote_end_.reset();
      return;
    }
    if (!quote_end_ && comment_ == '\0') quote_end_ = quote_end(text_, at_, style_);
    if (!quote_end_) comment();
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

  void number() {
    const std::size_t first = at_;
    const Notation number = parts_of_number(text_.substr(first));
    at_ += number.length;
    // 1.2.3 is a version.
    const bool is_version = peek(0) == '.' && is_digit(peek(1));
    while (peek(0) == '.' && is_digit(peek(1))) at_ = end_of_run(text_, at_ + 1, is_digit);
    const std::size_t length = at_ - first;
    const auto significant = static_cast<std::uint32_t>(significant_digits(number).size());
    if (is_suffix(number.suffix) && !is_version && significant > 0 && length <= most_digits)
      literals_.push_back(
          {first, length, significant, comment_ != '\0', digits_of(text_.substr(first, length))});
  }

  std::string_view text_;
  CommentStyle style_;
  std::size_t at_ = 0;
  std::optional<std::size_t> quote_end_;
  std::string* code_;
  char comment_ = '\0';  ///< '/' to the end of the line, '*' to its mark
  std::vector<Literal> literals_;
};

}  // namespace

Digits digits_of(std::string_view number) {
  if (number.starts_with('-') || number.starts_with('+')) number.remove_prefix(1);
  const Notation parts = parts_of_number(number);
  Digits result{.text = significant_digits(parts)};
  if (result.text.empty()) return {};
  int exponent = 0;
  if (!parts.exponent.empty()) {
    const std::string_view value = parts.exponent.substr(parts.exponent[1] == '+' ? 2 : 1);
    std::from_chars(value.data(), value.data() + value.size(), exponent);
  }
  // No number of a source text has a larger exponent; a sum with it does not overflow.
  const auto behind = std::ranges::count_if(parts.fraction, is_digit);
  result.exponent =
      static_cast<int>(std::ssize(result.text) - behind) + std::clamp(exponent, -100'000, 100'000);
  const std::size_t end = result.text.find_last_not_of('0') + 1;
  if (parts.has_point) result.last_zeros = result.text.size() - end;
  result.text.resize(end);
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
