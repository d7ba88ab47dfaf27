#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

/// The digits of a fit.
namespace shadefit {

static_assert(std::numeric_limits<long double>::digits > std::numeric_limits<double>::digits,
              "the digits of a fit are measured in an arithmetic wider than double");

/// Relative. Rounding a parameter to double costs up to 1.1e-16. 1e-14 is promised, and the next larger rule
/// gives more.
inline constexpr double settled = 2e-15;
/// The most digits that are claimed: 15 would rest on the last bit of a double.
inline constexpr int most_digits = 14;

/// The digits that a relative Newton step leaves: floor(-log10), from 0 to `most_digits`.
inline int correct_digits(long double relative_step) {
  if (std::isnan(relative_step)) return 0;
  const long double digits = std::floor(-std::log10(relative_step));  // infinite for a step of 0
  return static_cast<int>(std::clamp(digits, 0.0L, static_cast<long double>(most_digits)));
}

}  // namespace shadefit
