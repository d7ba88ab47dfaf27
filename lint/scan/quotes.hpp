#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "lint/scan/literals.hpp"

/// Texts in quotes, which hide the signs of comments.
namespace shadefit::lint {

struct Quote {
  std::size_t end = 0;  ///< of its content
  /// Whether it may have several lines, as a shader in a template of JavaScript has. Such a text may have
  /// comments of its own.
  bool has_lines = false;
};

/// Finds the quotes of a text.
class QuoteFinder {
 public:
  QuoteFinder(std::string_view text, CommentStyle style) : text_(text), style_(style) {}

  /// The quote that begins at this byte, outside of comments and of other quotes. A quote without an end does
  /// not count: it may be an apostrophe.
  std::optional<Quote> at(std::size_t begin);

 private:
  char before(std::size_t at) const { return at > 0 ? text_[at - 1] : '\0'; }
  char behind(std::size_t at) const { return at + 1 < text_.size() ? text_[at + 1] : '\0'; }

  std::optional<Quote> double_quote(std::size_t begin);
  std::optional<Quote> apostrophe(std::size_t begin);
  std::optional<Quote> raw_text(std::size_t begin);
  std::optional<Quote> pattern(std::size_t begin) const;
  std::optional<Quote> in_line(std::size_t begin) const;
  std::optional<Quote> until(std::size_t first, std::string_view closing, bool has_escapes);

  std::string_view text_;
  CommentStyle style_;
  bool is_one_open_ =
      false;  ///< whether the end of a long quote was not found: the next ones are not trusted
};

}  // namespace shadefit::lint
