#include "fit/verdicts/verdict.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "approx/scalar.hpp"

namespace shadefit {

namespace {

/// The digits after the point; fewer, or negative, where an exponent moves the point to the right.
int decimals_of(std::string_view printed) {
  const auto mark = std::min(printed.find_first_of("eE"), printed.size());
  const auto point = std::min(printed.find('.'), mark);
  int exponent = 0;
  if (mark < printed.size()) {
    const auto digits = printed.substr(mark + (printed[mark + 1] == '+' ? 2 : 1));
    std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
  }
  return static_cast<int>(mark - std::min(point + 1, mark)) - exponent;
}

}  // namespace

double last_unit(std::string_view printed) {
  return 1 / power(10.0, decimals_of(printed));
}

long units_off(std::string_view printed, double computed) {
  // 10^decimals is exact in a long double up to 27 decimals, and std::round takes halves away from zero.
  const long double scale = power(10.0L, decimals_of(printed));
  const long double rounded = std::round(static_cast<long double>(computed) * scale);
  const long double stated = std::round(constant<long double>(printed) * scale);
  const long double gap = std::abs(rounded - stated);
  const auto most = static_cast<long double>(std::numeric_limits<long>::max());
  return std::isnan(gap) || gap >= most ? std::numeric_limits<long>::max() : static_cast<long>(gap);
}

Judgement judge(std::string_view printed, const Alternative& computed, std::span<const Alternative> others) {
  const long off = units_off(printed, computed.value);
  if (off == 0) return {Verdict::confirmed, computed.objective, computed.value};
  if (off == 1) return {Verdict::rounding, computed.objective, computed.value};
  for (const Alternative& other : others) {
    if (units_off(printed, other.value) == 0) return {Verdict::other_objective, other.objective, other.value};
  }
  return {Verdict::refuted, "", computed.value};
}

}  // namespace shadefit
