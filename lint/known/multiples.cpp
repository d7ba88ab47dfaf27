#include <algorithm>
#include <array>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

#include "fit/support/decimal.hpp"
#include "lint/known/closed_form.hpp"
#include "lint/known/known_set.hpp"

namespace shadefit::lint {
namespace {

struct Factor {
  std::string_view words;
  double value;
};

/// Of exponentials and logarithms of base 2 and e, of angles, of integrals over the sphere, and of 8-bit
/// values.
constexpr std::array<Factor, 10> factors{{
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

std::vector<KnownSet> multiples_of(const std::vector<KnownSet>& sets) {
  std::vector<KnownSet> multiples;
  for (const KnownSet& set : sets) {
    if (set.constants.size() < 2) continue;
    for (const Factor& factor : factors) {
      KnownSet multiple = set;
      multiple.variants.clear();
      multiple.times = factor.words;
      multiple.factor = factor.value;
      for (KnownConstant& constant : multiple.constants) constant = multiple_of(constant, factor.value);
      multiples.push_back(std::move(multiple));
    }
  }
  return multiples;
}

}  // namespace shadefit::lint
