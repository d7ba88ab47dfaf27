#include <cmath>
#include <numbers>

#include "lint/scan/known_set.hpp"

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

}  // namespace shadefit::lint
