#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

#include "fit/support/decimal.hpp"
#include "lint/known/known_set.hpp"

namespace shadefit::lint {
namespace {

bool is_simple_fraction(double value, double slack) {
  constexpr int largest_denominator = 16, largest_numerator = 64;
  for (int denominator = 1; denominator <= largest_denominator; ++denominator) {
    const double numerator = value * denominator, whole = std::round(numerator);
    if (whole > largest_numerator) return false;
    if (whole >= 1 && std::abs(numerator - whole) <= slack * whole) return true;
  }
  return false;
}

/// Of exponentials and logarithms of base 2 and e, of angles, of integrals over the sphere, and of 8-bit
/// values.
constexpr std::array<std::pair<std::string_view, double>, 10> factors{{
    {"ln 2", std::numbers::ln2},
    {"1/ln 2", 1 / std::numbers::ln2},
    {"2", 2},
    {"1/2", 0.5},
    {"pi", std::numbers::pi},
    {"1/pi", std::numbers::inv_pi},
    {"180/pi", 180 * std::numbers::inv_pi},
    {"pi/180", std::numbers::pi / 180},
    {"255", 255},
    {"1/255", 1.0 / 255},
}};

/// Without the zeros before and behind the others.
std::size_t count_digits(double value) {
  constexpr int all_digits = 15;
  std::string text = decimal(value, all_digits);
  text.resize(std::min(text.find('e'), text.size()));
  std::erase_if(text, [](char c) { return c < '0' || '9' < c; });
  const std::size_t first = text.find_first_not_of('0');
  return first == std::string::npos ? 0 : text.find_last_not_of('0') - first + 1;
}

/// A number and its exact multiple by 255 differ by at most three digits.
KnownConstant multiple_of(const KnownConstant& constant, double factor) {
  constexpr int more_digits = 3;
  const std::size_t digits = count_digits(constant.value);
  KnownConstant product = constant;
  product.enough_digits = digits;
  product.value = constant.value * factor;
  product.printed = decimal(product.value, static_cast<int>(digits) + more_digits);
  product.is_common = is_common_number(product.value);
  return product;
}

}  // namespace

bool is_common_number(double value) {
  namespace numbers = std::numbers;
  if (value == 0) return true;
  // Half a unit of the seventh digit, relative to the number.
  const double unit = std::pow(10, std::floor(std::log10(std::abs(value))) - 6);
  const double slack = 0.5 * unit / std::abs(value);
  for (const double factor :
       {1.0, numbers::pi, numbers::inv_pi, numbers::sqrt2, numbers::ln2, 1 / numbers::ln2})
    if (is_simple_fraction(std::abs(value) / factor, slack)) return true;
  return false;
}

std::vector<KnownSet> multiples_of(const std::vector<KnownSet>& sets) {
  std::vector<KnownSet> multiples;
  for (const KnownSet& set : sets) {
    if (set.constants.size() < 2) continue;
    for (const auto& [words, factor] : factors) {
      KnownSet& multiple = multiples.emplace_back(set);
      multiple.variants.clear();
      multiple.times = words;
      multiple.factor = factor;
      for (KnownConstant& constant : multiple.constants) constant = multiple_of(constant, factor);
    }
  }
  return multiples;
}

}  // namespace shadefit::lint
