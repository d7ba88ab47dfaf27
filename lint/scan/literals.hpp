#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The decimal numbers of a source text.
namespace shadefit::lint {

/// How a language writes comments.
enum class CommentStyle {
  c,     ///< // and /* */
  rust,  ///< the same, and ' may begin a lifetime
  hash,  ///< #
  none,  ///< a text such as Markdown
};

/// The digits of a decimal number without sign, leading and trailing zeros: "45" and exponent -1 for 0.0450.
struct Digits {
  std::string text;  ///< empty: the number is 0
  int exponent = 0;  ///< the number is 0.TEXT times 10^exponent
  /// How many zeros behind the point stand at the end: they say how exact the number is.
  std::size_t last_zeros = 0;
  bool operator==(const Digits& other) const { return text == other.text && exponent == other.exponent; }
};

/// The digits of a number such as "-5.55473", "1.5e-3" or "5.55473f".
Digits digits_of(std::string_view number);

struct Literal {
  std::size_t offset = 0, length = 0;  ///< in bytes, without a sign, with its suffix
  std::uint32_t significant = 0;       ///< digits
  bool is_in_comment = false;
  Digits digits = {};
};

/// The numbers of a text in order, except those with a hexadecimal prefix, those inside a word or a version
/// (1.2.3), and those with more than `most_digits` digits.
std::vector<Literal> literals_of(std::string_view text, CommentStyle style);

inline constexpr std::size_t most_digits = 40;

/// The text with blanks in place of its comments, byte for byte at the same places.
std::string with_blank_comments(std::string_view text, CommentStyle style);

/// A text with its numbers.
struct ScannedText {
  std::string_view text;
  CommentStyle style;
  std::span<const Literal> literals;
};

}  // namespace shadefit::lint
