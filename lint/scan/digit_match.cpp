#include "lint/scan/digit_match.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace shadefit::lint {
namespace {

/// The text rounded half up to n digits, without trailing zeros; and whether that added a digit before the
/// first.
Digits rounded_to(const Digits& digits, std::size_t n) {
  Digits result{digits.text.substr(0, n), digits.exponent};
  if (n < digits.text.size() && digits.text[n] >= '5') {
    std::size_t i = n;
    while (i > 0 && result.text[i - 1] == '9') result.text[--i] = '0';
    if (i > 0) {
      ++result.text[i - 1];
    } else {
      result.text.insert(result.text.begin(), '1');
      ++result.exponent;
    }
  }
  while (!result.text.empty() && result.text.back() == '0') result.text.pop_back();
  return result;
}

/// The text cut to n digits, without trailing zeros.
Digits cut_to(const Digits& digits, std::size_t n) {
  Digits result{digits.text.substr(0, n), digits.exponent};
  while (!result.text.empty() && result.text.back() == '0') result.text.pop_back();
  return result;
}

bool has_digits_of_float(const Digits& found, const Digits& published) {
  constexpr std::size_t digits_of_a_float = 7;
  return found.text.size() >= digits_of_a_float && std::abs(found.exponent - published.exponent) <= 1 &&
         static_cast<float>(number_of(found)) == static_cast<float>(number_of(published));
}

/// Whether one edit makes `a` of `b`: a digit replaced, inserted or left out, or two neighbours swapped.
bool is_one_edit(std::string_view a, std::string_view b) {
  if (a.size() > b.size()) std::swap(a, b);
  if (b.size() - a.size() > 1) return false;
  const auto [in_a, in_b] = std::mismatch(a.begin(), a.end(), b.begin());
  const auto first = static_cast<std::size_t>(in_a - a.begin());
  if (b.size() > a.size()) return a.substr(first) == b.substr(first + 1);
  if (a.substr(first + 1) == b.substr(first + 1)) return true;
  return first + 1 < a.size() && a[first] == b[first + 1] && a[first + 1] == b[first] &&
         a.substr(first + 2) == b.substr(first + 2);
}

}  // namespace

double number_of(const Digits& digits) {
  const std::string text = "0." + digits.text + "e" + std::to_string(digits.exponent);
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

std::optional<DigitMatch> match_digits(const Digits& found, const Digits& published) {
  if (found == published) return DigitMatch::same;
  const std::size_t count = published.text.size();
  if (count < least_digits_to_vary || found.text.empty()) return std::nullopt;
  if (found.text.size() > count && rounded_to(found, count) == published) return DigitMatch::longer;
  if (has_digits_of_float(found, published)) return DigitMatch::float32;
  constexpr std::size_t least_rounded = 3;
  const std::size_t shorter = found.text.size();
  if (least_rounded <= shorter && shorter < count &&
      (found == rounded_to(published, shorter) || found == cut_to(published, shorter)))
    return DigitMatch::rounded;
  if (found.text == published.text) return DigitMatch::shifted;
  if (std::abs(found.exponent - published.exponent) <= 1 && is_one_edit(found.text, published.text))
    return DigitMatch::edited;
  return std::nullopt;
}

}  // namespace shadefit::lint
