#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The letters of a formula, read from the left.
namespace shadefit {

bool is_digit(char c);

/// Whether a name may begin with a letter.
bool begins_name(char c);

/// A text and the place in it that is read next. It must not outlive the text.
class FormulaText {
 public:
  explicit FormulaText(std::string_view text) : text_(text) {}

  std::size_t place() const { return place_; }
  void go_to(std::size_t place) { place_ = place; }

  /// The letter at a place; '\0' behind the end.
  char at(std::size_t i) const { return i < text_.size() ? text_[i] : '\0'; }

  /// The letter that is `ahead` places from the next one.
  char next(std::size_t ahead = 0) const { return at(place_ + ahead); }

  std::string_view rest() const { return text_.substr(std::min(place_, text_.size())); }

  /// Moves to the next letter that is not a space, and returns it; '\0' at the end.
  char peek();

  /// Whether nothing but spaces is left.
  bool is_at_end();

  bool begins_number() { return is_digit(peek()) || (peek() == '.' && is_digit(next(1))); }
  bool begins_atom() { return begins_number() || begins_name(peek()) || peek() == '('; }

  /// Moves behind a letter or a word, if it is what comes next.
  bool skip(char c);
  bool skip(std::string_view word);

  /// The same for a sign before a factor. In C two of them would be a decrement.
  bool skip_minus();

  void expect(char c);

  /// A letter or underscore, then letters, digits and underscores; empty if none comes next.
  std::string_view name();

  /// The decimal text of a number is kept, with a digit on both sides of its point. The suffix of a float or
  /// a half is left out. A hexadecimal double as `hex_text` prints it becomes all its decimal digits.
  std::string number();

  /// Moves behind the sign of a power, `^` or `**`.
  bool skip_power() { return skip('^') || skip("**"); }

  /// Where the text is not an expression: at a `return`, a `=`, or a `;` that is not at its end.
  std::optional<std::size_t> statement() const;

  /// The place of the comma or parenthesis that ends an argument.
  std::size_t end_of_argument() const;

  /// Throws std::invalid_argument: the formula, what was expected, and the place (1 for the first letter):
  /// the next, or the first letter from `where` that is not a space.
  [[noreturn]] void fail(const std::string& expected, std::optional<std::size_t> where = {}) const;

 private:
  std::string_view text_;
  std::size_t place_ = 0;
};

/// All names in a text, those of functions, suffixes and exponents too.
std::vector<std::string> names_in(std::string_view text);

}  // namespace shadefit
