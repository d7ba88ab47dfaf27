#include "fit/errors/ulps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace shadefit {
namespace {

/// The e with 2^e <= |x| < 2^(e+1); x is finite and not 0.
int binade(const Decimal50& x) {
  int above = 0;
  frexp(x, &above);  // |x| = m 2^above, m in [1/2, 1)
  return above - 1;
}

}  // namespace

Decimal50 ulp_at(const Decimal50& truth, const BinaryFormat& format) {
  int e = format.least_exponent;
  if (isinf(truth)) {
    e = format.greatest_exponent;
  } else if (truth != 0) {
    e = std::clamp(binade(truth), format.least_exponent, format.greatest_exponent);
  }
  return ldexp(Decimal50(1), e - format.digits + 1);
}

bool overflows(const Decimal50& truth, const BinaryFormat& format) {
  if (isinf(truth)) return true;
  const Decimal50 half_ulp = ldexp(Decimal50(1), format.greatest_exponent - format.digits);
  return abs(truth) >= ldexp(Decimal50(1), format.greatest_exponent + 1) - half_ulp;
}

double ulps_off(double computed, const Decimal50& truth, const BinaryFormat& format) {
  if (isnan(truth)) throw std::invalid_argument("the truth is not a number");
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (std::isnan(computed)) return infinity;
  if (std::isinf(computed)) {
    return overflows(truth, format) && (computed > 0) == (truth > 0) ? 0 : infinity;
  }
  if (isinf(truth)) return infinity;
  return Decimal50(abs(Decimal50(computed) - truth) / ulp_at(truth, format)).convert_to<double>();
}

}  // namespace shadefit
