#include "lint/scan/notation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "lint/scan/characters.hpp"
#include "lint/scan/literals.hpp"

namespace shadefit::lint {
namespace {

/// The digits at the start of a text, with the separators between them.
std::string_view leading_digits(std::string_view text) {
  std::size_t n = 0;
  while (n < text.size() &&
         (is_digit(text[n]) || (n > 0 && n + 1 < text.size() && (text[n] == '_' || text[n] == '\'') &&
                                is_digit(text[n - 1]) && is_digit(text[n + 1]))))
    ++n;
  return text.substr(0, n);
}

/// "e-3" at the start of a text, or nothing.
std::string_view leading_exponent(std::string_view text) {
  if (text.empty() || (text[0] != 'e' && text[0] != 'E')) return {};
  const std::size_t first = text.size() > 1 && (text[1] == '-' || text[1] == '+') ? 2 : 1;
  const std::size_t end = end_of_run(text, first, is_digit);
  return text.substr(0, end > first ? end : 0);
}

/// The exponent in the style of another: its letter, its '+', and its leading zeros.
std::string exponent_like(std::string_view style, int value) {
  const bool has_sign = style[1] == '-' || style[1] == '+';
  const std::string_view digits = style.substr(has_sign ? 2 : 1);
  const std::string text = fmt::format("{:0{}}", std::abs(value), digits[0] == '0' ? digits.size() : 0);
  return fmt::format("{}{}{}", style[0], value < 0 ? "-" : style[1] == '+' ? "+" : "", text);
}

/// The parts of a number as text. It has a point if the literal has one or if digits follow.
std::string joined(const Notation& literal, std::string whole, std::string fraction) {
  if (whole.empty() && !literal.whole.empty()) whole = "0";
  if (whole == "0" && literal.whole.empty() && !fraction.empty()) whole.clear();
  if (fraction.empty() && literal.has_point && !literal.fraction.empty()) fraction = "0";
  return whole + (literal.has_point || !fraction.empty() ? "." : "") + fraction;
}

std::string with_exponent(const Notation& literal, const Notation& to, std::string_view published) {
  const std::string digits = significant_digits(to);
  const Digits mantissa = digits_of(fmt::format("{}.{}", literal.whole, literal.fraction));
  // The mantissa is 0.DIGITS times 10^point.
  const int point = mantissa.text.empty() ? 1 : mantissa.exponent;
  const auto before = static_cast<std::size_t>(std::max(point, 0));
  std::string whole = digits.substr(0, before), fraction = digits.substr(std::min(before, digits.size()));
  whole.resize(before, '0');
  if (point < 0) fraction.insert(0, static_cast<std::size_t>(-point), '0');
  const int exponent = digits_of(published).text.empty() ? 0 : digits_of(published).exponent - point;
  return joined(literal, whole, fraction) + exponent_like(literal.exponent, exponent);
}

}  // namespace

std::string significant_digits(const Notation& number) {
  std::string digits;
  for (const std::string_view part : {number.whole, number.fraction})
    for (const char c : part)
      if (is_digit(c) && (c != '0' || !digits.empty())) digits += c;
  return digits;
}

bool is_suffix(std::string_view letters) {
  constexpr std::array<std::string_view, 14> known{"",    "f",   "F",   "h", "H", "l",  "L",
                                                   "f32", "f64", "f16", "d", "D", "lf", "m"};
  letters.remove_prefix(end_of_run(letters, 0, [](char c) { return c == '_'; }));
  return std::ranges::find(known, letters) != known.end();
}

Notation parts_of_number(std::string_view text) {
  Notation number;
  number.whole = leading_digits(text);
  std::size_t at = number.whole.size();
  if (at < text.size() && text[at] == '.') {
    number.has_point = true;
    number.fraction = leading_digits(text.substr(at + 1));
    at += 1 + number.fraction.size();
  }
  number.exponent = leading_exponent(text.substr(at));
  at += number.exponent.size();
  number.length = end_of_run(text, at, is_of_name);
  number.suffix = text.substr(at, number.length - at);
  return number;
}

bool is_before_power_of_ten(std::string_view text, std::size_t end) {
  constexpr std::size_t looked_at = 16;
  const std::string_view rest = line_at(text.substr(end, looked_at), 0);
  return rest.find("10^") != std::string_view::npos || rest.find("10**") != std::string_view::npos;
}

std::string rewritten(std::string_view literal, std::string_view published) {
  if (published.starts_with('-') || published.starts_with('+')) published.remove_prefix(1);
  const Notation as = parts_of_number(literal), to = parts_of_number(published);
  const std::string suffix(as.suffix);
  if (!as.exponent.empty()) return with_exponent(as, to, published) + suffix;
  return joined(as, std::string(to.whole), std::string(to.fraction)) + std::string(to.exponent) + suffix;
}

}  // namespace shadefit::lint
