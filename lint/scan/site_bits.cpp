#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <string>

#include "lint/scan/characters.hpp"
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
    bits += bits_of_order() + bits_of_names();
    if (!set_.times.empty()) bits -= bits_of_a_factor();
    if (bits < least_bits) return bits;
    // Each number may match any of the different numbers there, so the bits are fewer.
    const auto count = static_cast<double>(site_.numbers.size());
    const auto there = static_cast<double>(count_different());
    return bits - count * std::log2(std::max(1.0, there / count));
  }

 private:
  /// There are ten factors, and a single number of six digits is near a multiple too often.
  double bits_of_a_factor() const {
    const double bits_of_ten = std::log2(10);
    return site_.numbers.size() > 1 ? bits_of_ten : 2 * bits_of_ten;
  }

  std::size_t first() const { return site_.numbers.front().literal; }
  std::size_t last() const { return site_.numbers.back().literal; }

  const Digits& digits_at(std::size_t literal) const { return text_.literals[literal].digits; }

  /// The bits of one number: log2 of 10 for each digit but the first, since small first digits are common.
  double bits_of(const SiteNumber& number) const {
    const double bits_of_a_digit = std::log2(10);
    const KnownConstant& constant = set_.constants[number.constant];
    constexpr std::size_t digits_of_a_common_number = 3;
    std::size_t digits = digits_of(constant.printed).text.size();
    if (!set_.times.empty()) digits = std::min(digits, digits_at(number.literal).text.size());
    const std::size_t published = constant.is_common ? std::min(digits, digits_of_a_common_number) : digits;
    const std::size_t found = std::min(published, digits_at(number.literal).text.size());
    const auto bits = [&](std::size_t count) { return bits_of_a_digit * (static_cast<double>(count) - 1); };
    if (number.variant) return set_.variants[*number.variant].is_borrowed ? 0 : bits(published);
    switch (number.match) {
      case DigitMatch::same:
      case DigitMatch::longer:
      case DigitMatch::float32:
        return bits(published);
      case DigitMatch::enough:
      case DigitMatch::rounded:
        return bits(found) - 1;  // rounded or cut off
      case DigitMatch::shifted:
        return bits(published) - 3;  // some eight other places of the point
      case DigitMatch::usual_slip:
        return bits(published) - 1;  // one of two
      case DigitMatch::edited:
        return bits(published) - bits_of_edits(published);
      case DigitMatch::rounded_and_edited:
        return bits(found) - 1 - bits_of_edits(found);
    }
    return 0;
  }

  /// A text of n digits has some 20 n neighbours at one edit.
  static double bits_of_edits(std::size_t digits) { return std::log2(20 * static_cast<double>(digits)); }

  std::size_t count_different() const {
    std::set<std::string_view> texts;
    for (std::size_t i = first(); i <= last(); ++i) texts.insert(digits_at(i).text);
    return texts.size();
  }

  /// Whether a number is only a factor of the next one, as both 0.6 in 0.6 * 0.6 * 2.51.
  bool is_factor(std::size_t literal) const {
    const std::string_view between = text_between(text_, literal, literal + 1);
    return std::ranges::count(between, '*') == 1 &&
           std::ranges::all_of(between, [](char c) { return c == '*' || is_blank(c); });
  }

  /// Where the product begins whose last factor is this number.
  std::size_t product_begin(std::size_t literal) const {
    while (literal > 0 && is_factor(literal - 1)) --literal;
    return literal;
  }

  /// Whether nothing stands between the numbers but their factors.
  bool are_neighbours() const {
    for (std::size_t i = 1; i < site_.numbers.size(); ++i)
      if (product_begin(site_.numbers[i].literal) != site_.numbers[i - 1].literal + 1) return false;
    return true;
  }

  /// The bits of one order in n!, if all n constants are in the published order: next to each other, or as a
  /// column of a matrix. Three more bits if they are a whole list, (a, b, c): a row of numbers at a random
  /// place is not one. Half of that if a list begins with them, as a matrix with its first row.
  double bits_of_order() const {
    const std::size_t count = set_.constants.size();
    if (site_.numbers.size() != count) return 0;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < count; ++i) {
      if (site_.numbers[i].constant != i) return 0;
      places.push_back(site_.numbers[i].literal);
    }
    constexpr double bits_of_a_list = 3;
    const double bits = std::lgamma(static_cast<double>(count) + 1) / std::log(2.0);
    if (!are_neighbours()) return is_column(text_, places) ? bits : 0;
    const std::size_t begin = product_begin(first());
    if (!is_whole_list(text_, begin, last()))
      return bits + (begins_list(text_.text, text_.literals[begin]) ? bits_of_a_list / 2 : 0);
    return bits + bits_of_a_list + bits_of_decimals();
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

  /// The bits of finding all words of the id in the lines of the numbers, as in cosineLobe.sharpness = 2.133.
  /// In 148 000 lines with numbers of some 140 graphics programs, the words of no id came together more than
  /// 6 times; 10 bits are one in 1000. A name does not excuse wrong digits.
  double bits_of_names() const {
    constexpr double bits_of_an_id = 10;
    constexpr std::size_t least_words = 2, shortest = 4;
    const bool is_exact = std::ranges::all_of(site_.numbers, [](const SiteNumber& number) {
      return !number.variant && number.match <= DigitMatch::float32;
    });
    if (!is_exact || site_.numbers.size() != set_.constants.size()) return 0;
    const std::string lines = lines_of_numbers();
    std::size_t words = 0;
    std::istringstream id(set_.id);
    for (std::string word; std::getline(id, word, '-');) {
      if (word.size() < shortest) continue;
      if (lines.find(word) == std::string::npos) return 0;
      ++words;
    }
    return words >= least_words ? bits_of_an_id : 0;
  }

  /// In lower case, from the start of the first line to the last number.
  std::string lines_of_numbers() const {
    const std::size_t begin = line_begin(text_.text, text_.literals[first()].offset);
    return in_small_letters(text_.text.substr(begin, text_.literals[last()].offset - begin));
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
