#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

#include "lint/scan/lists.hpp"
#include "lint/scan/sites.hpp"

namespace shadefit::lint {
namespace {

/// How much evidence the numbers of a site are.
class SiteBits {
 public:
  SiteBits(const ScannedText& text, const KnownSet& set, const Site& site)
      : text_(text), set_(set), site_(site) {}

  double bits() const {
    double bits = 0;
    for (const SiteNumber& number : site_.numbers) bits += bits_of(number);
    bits += bits_of_order();
    if (bits < least_bits) return bits;
    // Each number may match any of the different numbers there, so the bits are fewer.
    const auto count = static_cast<double>(site_.numbers.size());
    const auto there = static_cast<double>(count_different());
    return bits - count * std::log2(std::max(1.0, there / count));
  }

 private:
  std::size_t first() const { return site_.numbers.front().literal; }
  std::size_t last() const { return site_.numbers.back().literal; }

  const Digits& digits_at(std::size_t literal) const { return text_.literals[literal].digits; }

  /// The bits of one number: log2 of 10 for each digit but the first, since small first digits are common.
  double bits_of(const SiteNumber& number) const {
    const double bits_of_a_digit = std::log2(10);
    const KnownConstant& constant = set_.constants[number.constant];
    constexpr std::size_t digits_of_a_common_number = 3;
    const std::size_t digits = digits_of(constant.printed).text.size(),
                      published = constant.is_common ? std::min(digits, digits_of_a_common_number) : digits;
    const std::size_t found = std::min(published, digits_at(number.literal).text.size());
    const auto bits = [&](std::size_t count) { return bits_of_a_digit * (static_cast<double>(count) - 1); };
    if (number.variant) return set_.variants[*number.variant].is_borrowed ? 0 : bits(published);
    switch (number.match) {
      case DigitMatch::same:
      case DigitMatch::longer:
      case DigitMatch::float32:
        return bits(published);
      case DigitMatch::rounded:
        return bits(found) - 1;  // rounded or cut off
      case DigitMatch::shifted:
        return bits(published) - 3;  // some eight other places of the point
      case DigitMatch::usual_slip:
        return bits(published) - 1;  // one of two
      case DigitMatch::edited:
        // A text of n digits has some 20 n neighbours at one edit.
        return bits(published) - std::log2(20 * static_cast<double>(published));
    }
    return 0;
  }

  std::size_t count_different() const {
    std::set<std::string_view> texts;
    for (std::size_t i = first(); i <= last(); ++i) texts.insert(digits_at(i).text);
    return texts.size();
  }

  /// The bits of one order in n!, if all n constants are there in the published order, with no other number
  /// between them. Three more bits if they are a whole list, (a, b, c): a row of numbers at a random place is
  /// not one. Half of that if a list begins with them, as a matrix with its first row.
  double bits_of_order() const {
    const std::size_t count = set_.constants.size();
    if (site_.numbers.size() != count || last() - first() + 1 != count) return 0;
    for (std::size_t i = 0; i < count; ++i)
      if (site_.numbers[i].constant != i) return 0;
    constexpr double bits_of_a_list = 3;
    const double bits = std::lgamma(static_cast<double>(count) + 1) / std::log(2.0);
    if (is_whole_list(text_, first(), last())) return bits + bits_of_a_list + bits_of_decimals();
    return bits + (begins_list(text_.text, text_.literals[first()]) ? bits_of_a_list / 2 : 0);
  }

  /// The bits of a list with the same number of decimals: as published, or rounded as 0.212, 0.715, 0.072.
  /// One choice between rounding and cutting holds for all, and a zero behind the point is a digit too.
  double bits_of_decimals() const {
    constexpr std::size_t least_numbers = 3;
    const auto are_all = [&](DigitMatch match, bool (*is_so)(const Digits&, const Digits&)) {
      return std::ranges::all_of(site_.numbers, [&](const SiteNumber& number) {
        return number.match == match && !number.variant &&
               is_so(digits_at(number.literal), digits_of(set_.constants[number.constant].printed));
      });
    };
    const bool are_published = are_all(DigitMatch::same, [](const Digits&, const Digits&) { return true; });
    const bool are_short = are_all(DigitMatch::rounded, is_rounded) || are_all(DigitMatch::rounded, is_cut);
    if (site_.numbers.size() < least_numbers || !(are_published || are_short) ||
        !have_same_decimals(text_, first(), last()))
      return 0;
    double bits = are_short ? static_cast<double>(site_.numbers.size()) - 1 : 0;
    for (const SiteNumber& number : site_.numbers)
      bits += std::log2(10) * std::max(0, -digits_at(number.literal).exponent);
    return bits;
  }

  const ScannedText& text_;
  const KnownSet& set_;
  const Site& site_;
};

}  // namespace

double bits_of(const ScannedText& text, const KnownSet& set, const Site& site) {
  return SiteBits(text, set, site).bits();
}

}  // namespace shadefit::lint
