#include "lint/scan/literals.hpp"

#include <algorithm>
#include <charconv>
#include <optional>

#include "lint/scan/characters.hpp"
#include "lint/scan/quotes.hpp"

namespace shadefit::lint {
namespace {

/// Separators of digits in C++ and Rust.
constexpr bool is_separator(char c) {
  return c == '_' || c == '\'';
}

/// Scans a text for numbers.
class LiteralReader {
 public:
  LiteralReader(std::string_view text, CommentStyle style)
      : text_(text), style_(style), quotes_(text, style) {}

  std::vector<Literal> read() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (is_digit(c) || (c == '.' && is_digit(peek(1)))) {
        number();
      } else if (is_of_name(c)) {
        word();
      } else {
        if (style_ != CommentStyle::none) quote_or_comment();
        ++at_;
      }
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
    while (at_ < text_.size() && is_of_name(text_[at_])) ++at_;
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

  void digits(std::uint32_t& significant) {
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (is_digit(c)) {
        if (c != '0' || significant > 0) ++significant;
      } else if (!(is_separator(c) && is_digit(peek(1)) && is_digit(text_[at_ - 1]))) {
        return;
      }
    }
  }

  /// f, h, l, f32, f64: any other letters after the digits make a word of it.
  bool suffix() {
    const std::size_t first = at_;
    while (at_ < text_.size() && is_of_name(text_[at_])) ++at_;
    std::string_view letters = text_.substr(first, at_ - first);
    while (letters.starts_with('_')) letters.remove_prefix(1);
    return letters.empty() || letters == "f" || letters == "F" || letters == "h" || letters == "H" ||
           letters == "l" || letters == "L" || letters == "f32" || letters == "f64" || letters == "f16" ||
           letters == "d" || letters == "D" || letters == "lf" || letters == "m";
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
    std::uint32_t significant = 0;
    digits(significant);
    if (peek(0) == '.') {
      ++at_;
      digits(significant);
    }
    if ((peek(0) == 'e' || peek(0) == 'E') &&
        (is_digit(peek(1)) || ((peek(1) == '-' || peek(1) == '+') && is_digit(peek(2))))) {
      at_ += 2;
      while (is_digit(peek(0))) ++at_;
    }
    const bool is_number = suffix();
    // 1.2.3 is a version.
    const bool is_version = peek(0) == '.' && is_digit(peek(1));
    while (peek(0) == '.' && is_digit(peek(1))) {
      ++at_;
      while (is_digit(peek(0))) ++at_;
    }
    const std::size_t length = at_ - first;
    if (is_number && !is_version && significant > 0 && length <= most_digits)
      literals_.push_back({first, length, significant, comment_ != '\0', is_before_power_of_ten(),
                           digits_of(text_.substr(first, length))});
  }

  std::string_view text_;
  CommentStyle style_;
  std::size_t at_ = 0;
  QuoteFinder quotes_;
  std::optional<Quote> quote_;
  char comment_ = '\0';  ///< '/' to the end of the line, '*' to its mark
  std::vector<Literal> literals_;
};

}  // namespace

bool begins_hash_comment(std::string_view text, std::size_t at) {
  if (text[at] != '#') return false;
  std::size_t first = at;
  while (first > 0 && (text[first - 1] == ' ' || text[first - 1] == '\t')) --first;
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
  return LiteralReader(text, style).read();
}

}  // namespace shadefit::lint
