#include "fit/formula/formula_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <stdexcept>

#include "fit/support/hex_float.hpp"

namespace shadefit {
namespace {

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

/// How many letters of a text are a hexadecimal double such as 0x1.8p+3; 0 if it does not begin with one.
std::size_t length_of_hexadecimal(std::string_view text) {
  const std::size_t mark =
      text.starts_with("0x") ? text.find_first_not_of("0123456789abcdef.", 2) : text.npos;
  if (mark == text.npos || mark == 2 || text[mark] != 'p' || text.find_first_of("+-", mark) != mark + 1)
    return 0;
  const std::size_t first = mark + 2,
                    end = std::min(text.find_first_not_of("0123456789", first), text.size());
  return end > first ? end : 0;
}

/// Every digit of a double: each is a finite decimal number.
std::string exact_decimal(double value) {
  constexpr int most_digits = 767;
  std::array<char, most_digits + 400> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                 std::chars_format::general, most_digits);
  return {digits.data(), end.ptr};
}

}  // namespace

bool is_digit(char c) {
  return '0' <= c && c <= '9';
}

bool begins_name(char c) {
  return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || c == '_';
}

char FormulaText::peek() {
  while (is_space(next())) ++place_;
  return next();
}

bool FormulaText::is_at_end() {
  peek();
  return place_ >= text_.size();
}

bool FormulaText::skip(char c) {
  if (peek() != c) return false;
  ++place_;
  return true;
}

bool FormulaText::skip(std::string_view word) {
  peek();
  if (text_.substr(place_, word.size()) != word) return false;
  place_ += word.size();
  return true;
}

bool FormulaText::skip_minus() {
  if (!skip('-')) return false;
  if (peek() == '-') fail("one sign only");
  return true;
}

void FormulaText::expect(char c) {
  if (!skip(c)) fail(std::string("'") + c + "'");
}

std::string_view FormulaText::name() {
  peek();
  const std::size_t start = place_;
  while (begins_name(next()) || (place_ > start && is_digit(next()))) ++place_;
  return text_.substr(start, place_ - start);
}

std::string FormulaText::number() {
  const std::size_t start = place_;
  if (const std::size_t length = length_of_hexadecimal(text_.substr(place_)); length > 0) {
    const auto exact = parse_hex(text_.substr(place_, length));
    if (!exact) fail("a hexadecimal double as shadefit prints it, such as 0x1.8p+3", start);
    place_ += length;
    return exact_decimal(*exact);
  }
  const auto digits = [&] {
    const std::size_t first = place_;
    while (is_digit(next())) ++place_;
    return text_.substr(first, place_ - first);
  };
  std::string decimal(digits());
  bool is_float = false;
  if (decimal.empty()) decimal = "0";
  if (next() == '.') {
    ++place_;
    is_float = true;
    const std::string_view fraction = digits();
    if (!fraction.empty()) decimal += "." + std::string(fraction);
  }
  const std::size_t sign = next(1) == '+' || next(1) == '-' ? 1 : 0;
  if ((next() == 'e' || next() == 'E') && is_digit(next(1 + sign))) {
    decimal += text_.substr(place_, 1 + sign);
    place_ += 1 + sign;
    decimal += digits();
    is_float = true;
  }
  if (next() == '.') fail("a number with one point", start);
  double value = 0;
  if (std::from_chars(decimal.data(), decimal.data() + decimal.size(), value).ec != std::errc{})
    fail("a number within the range of a double", start);
  const char suffix = next();
  const bool has_suffix = (suffix == 'f' || suffix == 'F' || suffix == 'h' || suffix == 'H') &&
                          !begins_name(next(1)) && !is_digit(next(1)) && next(1) != '(';
  if (has_suffix && !is_float)
    fail("a point before the suffix, " + decimal + ".0" + suffix + ", or a '*'", start);
  if (has_suffix) ++place_;
  return decimal;
}

std::optional<std::size_t> FormulaText::statement() const {
  const auto is_at = [&](std::size_t i, std::string_view letters) {
    return i < text_.size() && letters.find(text_[i]) != letters.npos;
  };
  for (std::size_t i = 0; i < text_.size(); ++i) {
    const bool is_word = i == 0 || !(begins_name(text_[i - 1]) || is_digit(text_[i - 1]));
    const bool returns = is_word && text_.substr(i).starts_with("return") && is_at(i + 6, " (;");
    const bool sets = text_[i] == '=' && !is_at(i + 1, "=") && !(i > 0 && is_at(i - 1, "=<>!"));
    const bool ends = text_[i] == ';' && text_.find_first_not_of(" \t\r\n;", i) != text_.npos;
    if (returns || sets || ends) return i;
  }
  return std::nullopt;
}

std::vector<std::string> names_in(std::string_view text) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t start = i++;
    if (!begins_name(text[start])) continue;
    while (i < text.size() && (begins_name(text[i]) || is_digit(text[i]))) ++i;
    names.emplace_back(text.substr(start, i - start));
  }
  return names;
}

std::size_t FormulaText::end_of_argument() const {
  std::size_t end = place_;
  for (int open = 0; end < text_.size(); ++end) {
    if (text_[end] == '(') ++open;
    if (text_[end] == ')' && --open < 0) break;
    if (text_[end] == ',' && open == 0) break;
  }
  return end;
}

void FormulaText::fail(const std::string& expected, std::optional<std::size_t> where) const {
  std::size_t place = where.value_or(place_);
  while (where && is_space(at(place))) ++place;
  throw std::invalid_argument("formula '" + std::string(text_) + "': expected " + expected + " at place " +
                              std::to_string(place + 1));
}

}  // namespace shadefit
