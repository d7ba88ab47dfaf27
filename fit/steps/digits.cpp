#include "fit/steps/digits.hpp"

#include <algorithm>
#include <cmath>

namespace shadefit {

int correct_digits(long double relative_step) {
  if (std::isnan(relative_step)) return 0;
  const long double digits = std::floor(-std::log10(relative_step));  // infinite for a step of 0
  return static_cast<int>(std::clamp(digits, 0.0L, static_cast<long double>(most_digits)));
}

}  // namespace shadefit
