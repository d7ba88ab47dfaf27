#pragma once

#include <cmath>
#include <limits>

#include "fit/proof/interval.hpp"

/// Conversion between intervals and doubles, always rounded outward, so that bounds stay true.
namespace shadefit {

/// The bits of an interval's ends.
inline int interval_precision() {
  return static_cast<int>(mpfi_get_prec(Interval().backend().data()));
}

/// The interval of all numbers from one double to another, both exact; lower <= upper.
inline Interval span_of(double lower, double upper) {
  Interval result;
  mpfi_interv_d(result.backend().data(), lower, upper);
  return result;
}

/// The interval of all numbers.
inline Interval any_number() {
  return span_of(-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity());
}

/// An order of intervals without NaN, by their lower ends, then by their upper ones.
inline bool comes_before(const Interval& x, const Interval& y) {
  const auto &a = x.backend().data()[0], &b = y.backend().data()[0];
  const int by_lower = mpfr_cmp(&a.left, &b.left);
  return by_lower != 0 ? by_lower < 0 : mpfr_less_p(&a.right, &b.right) != 0;
}

/// The numbers that are in both; there must be one.
inline Interval shared_by(const Interval& x, const Interval& y) {
  Interval result;
  mpfi_intersect(result.backend().data(), x.backend().data(), y.backend().data());
  return result;
}

/// The largest double that is at most every number of x; NaN if x is NaN.
inline double lower_end(const Interval& x) {
  return mpfr_get_d(&x.backend().data()->left, MPFR_RNDD);
}

/// The smallest double that is at least every number of x; NaN if x is NaN.
inline double upper_end(const Interval& x) {
  return mpfr_get_d(&x.backend().data()->right, MPFR_RNDU);
}

/// Whether x is not NaN and bounded on both sides.
inline bool is_bounded(const Interval& x) {
  return mpfi_bounded_p(x.backend().data()) != 0;
}

/// At least upper - lower.
inline double width_of(const Interval& x) {
  return upper_end(Interval(x - x));  // from lower - upper to upper - lower
}

/// At least every |number| of x; infinite if x is NaN.
inline double largest_magnitude_in(const Interval& x) {
  const double lower = lower_end(x), upper = upper_end(x);
  if (std::isnan(lower) || std::isnan(upper)) return std::numeric_limits<double>::infinity();
  return std::fmax(-lower, upper);
}

/// At most every |number| of x; 0 if x is NaN.
inline double smallest_magnitude_in(const Interval& x) {
  const double lower = lower_end(x), upper = upper_end(x);
  if (lower > 0) return lower;
  return upper < 0 ? -upper : 0;
}

/// Whether all numbers of x have one sign and none is 0.
inline bool has_one_sign(const Interval& x) {
  return is_bounded(x) && mpfi_has_zero(x.backend().data()) <= 0;
}

/// Whether no number of x is above 0 (`is_never_positive`) or below 0 (`is_never_negative`).
inline bool is_never_positive(const Interval& x) {
  return upper_end(x) <= 0 && !std::isnan(lower_end(x));
}
inline bool is_never_negative(const Interval& x) {
  return lower_end(x) >= 0 && !std::isnan(upper_end(x));
}

}  // namespace shadefit
