#include "lint/scan/digit_match.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace shadefit::lint {
namespace {

/// The text cut to n digits, without trailing zeros.
Digits cut_to(const Digits& digits, std::size_t n) {
  const std::string_view text = std::string_view(digits.text).substr(0, n);
  return {std::string(text.substr(0, text.find_last_not_of('0') + 1)), digits.exponent};
}

/// The text rounded half up to n digits, without trailing zeros; rounding may add a leading digit.
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
  return cut_to(result, n + 1);
}

/// Whether one would print these digits for the float or for the published number: rounded or cut off.
/// 0.159301758125 for 0.1593017578125 is the same float, but nobody prints it: a digit was lost.
bool is_print_of_float(const Digits& found, const Digits& published) {
  if (!is_same_float(found, published)) return false;
  if (is_shortened(found, published)) return true;
  // A float has at most 112 digits.
  const auto nearest = static_cast<double>(static_cast<float>(number_of(published)));
  const Digits all = digits_of(fmt::format("{:.112e}", nearest));
  return found == rounded_to(all, found.text.size()) || found == cut_to(all, found.text.size());
}

/// Where a text differs from one that is not shorter, or its end.
std::size_t first_difference(std::string_view a, std::string_view b) {
  return static_cast<std::size_t>(std::ranges::mismatch(a, b).in1 - a.begin());
}

/// Whether the texts differ from this place on by two swapped neighbours alone.
bool is_swapped(std::string_view a, std::string_view b, std::size_t at) {
  return at + 1 < a.size() && a[at] == b[at + 1] && a[at + 1] == b[at] &&
         a.substr(at + 2) == b.substr(at + 2);
}

/// Whether one edit makes `a` of `b`: a digit replaced, inserted or left out, or two neighbours swapped.
bool is_one_edit(std::string_view a, std::string_view b) {
  if (a.size() > b.size()) std::swap(a, b);
  if (b.size() - a.size() > 1) return false;
  const std::size_t first = first_difference(a, b);
  if (b.size() > a.size()) return a.substr(first) == b.substr(first + 1);
  return a.substr(first + 1) == b.substr(first + 1) || is_swapped(a, b, first);
}

/// Whether one of the functions above makes these fewer digits of the published ones.
bool is_shortened_by(Digits (*shorten)(const Digits&, std::size_t), const Digits& found,
                     const Digits& published) {
  const std::size_t count = found.text.size();
  return 0 < count && count < published.text.size() && have_near_exponents(found, published) &&
         found == shorten(published, count);
}

}  // namespace

bool have_near_exponents(const Digits& found, const Digits& published) {
  return std::abs(found.exponent - published.exponent) <= 1;
}

bool is_same_float(const Digits& found, const Digits& published) {
  constexpr std::size_t digits_of_a_float = 7;
  return found.text.size() >= digits_of_a_float && have_near_exponents(found, published) &&
         static_cast<float>(number_of(found)) == static_cast<float>(number_of(published));
}

double number_of(const Digits& digits) {
  const std::string text = "0." + digits.text + "e" + std::to_string(digits.exponent);
  double value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

bool is_rounded(const Digits& found, const Digits& published) {
  return is_shortened_by(rounded_to, found, published);
}

bool is_cut(const Digits& found, const Digits& published) {
  return is_shortened_by(cut_to, found, published);
}

bool is_shortened(const Digits& found, const Digits& published) {
  return is_rounded(found, published) || is_cut(found, published);
}

bool is_usual_slip(const Digits& found, const Digits& published) {
  const std::string &a = found.text, &b = published.text;
  if (a.size() != b.size() || found.exponent != published.exponent) return false;
  const std::size_t first = first_difference(a, b);
  if (first == a.size()) return false;
  if (is_swapped(a, b, first)) return true;
  if (a.substr(first + 1) != b.substr(first + 1)) return false;
  // The digit that differs is one of a double in the published number, and makes another double in the found
  // one.
  const auto is_double = [&](const std::string& text, std::size_t begin) {
    return begin + 1 < text.size() && text[begin] == text[begin + 1];
  };
  return (is_double(b, first) && first > 0 && is_double(a, first - 1)) ||
         (first > 0 && is_double(b, first - 1) && is_double(a, first));
}

bool is_edited(const Digits& found, const Digits& published) {
  return found.text.size() == published.text.size() && found.exponent == published.exponent &&
         found.text != published.text && is_one_edit(found.text, published.text);
}

std::optional<DigitMatch> match_digits(const Digits& found, const Digits& published) {
  if (found == published) return DigitMatch::same;
  const std::size_t count = published.text.size();
  constexpr std::size_t least_digits_to_shift = 3;
  if (count >= least_digits_to_shift && found.text == published.text) return DigitMatch::shifted;
  if (count < least_digits_to_vary || found.text.empty()) return std::nullopt;
  const std::size_t printed = count + published.last_zeros;
  if (found.text.size() > printed && rounded_to(found, printed) == published) return DigitMatch::longer;
  if (is_print_of_float(found, published)) return DigitMatch::float32;
  constexpr std::size_t least_rounded = 3;
  if (found.text.size() >= least_rounded && is_shortened(found, published)) return DigitMatch::rounded;
  if (have_near_exponents(found, published) && is_one_edit(found.text, published.text))
    return DigitMatch::edited;
  if (is_same_float(found, published)) return DigitMatch::float32;
  return std::nullopt;
}

}  // namespace shadefit::lint
