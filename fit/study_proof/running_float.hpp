#pragma once

#include <cmath>
#include <limits>
#include <string_view>

#include "fit/proof/interval.hpp"
#include "fit/proof/interval_ends.hpp"
#include "fit/scalars/narrow_result.hpp"

/// A program in float: what it should compute, what it may compute, and how far apart the two are.
namespace shadefit {

/// A value of a program whose every operation and function is rounded to the nearest float.
///
/// The error of an operation is what its operands' errors do to it, by the mean value theorem between the
/// true and the computed operands, and its own rounding. It is also never more than what the two enclosures
/// allow. That holds where a slope is infinite: next to a root the enclosures shrink with the box.
/// `RunningError` (fit/proof/running_error.hpp) has no second enclosure, so it cannot know that the float
/// 1 - x is not negative for x <= 1. Source: Higham 2002, "Accuracy and Stability of Numerical Algorithms",
/// 2nd edition, section 3.3.
struct RunningFloat {
  Interval value;     ///< encloses the true value
  Interval computed;  ///< encloses every float that the program may have, with its products rounded or not
  double error = 0;   ///< at least |computed - true|

  /// A float as an operand.
  static RunningFloat exact(const Interval& value) { return {value, value, 0}; }

  /// A number that is rounded to the nearest float before the program runs.
  static RunningFloat rounded_number(const Interval& value) { return rounded(value, value, Interval(0)); }

  /// An operation with true results in `value`; those of the computed operands lie in `result`, and differ
  /// by at most `inherited` before they are rounded.
  static RunningFloat rounded(const Interval& value, const Interval& result, const Interval& inherited) {
    const Interval rounding =
        Interval(largest_magnitude_in(result)) * Interval(half_ulp) + Interval(half_least);
    return enclosed(value, to_float(result), largest_magnitude_in(Interval(inherited + rounding)));
  }

  /// The same for an operation that rounds nothing.
  static RunningFloat enclosed(const Interval& value, const Interval& computed, double error) {
    constexpr double unknown = std::numeric_limits<double>::infinity();
    if (!is_bounded(value) || !is_bounded(computed)) return {value, any_number(), unknown};
    return {value, computed, std::fmin(error, largest_magnitude_in(Interval(computed - value)))};
  }

  /// What an error of an operand does to a result; `slope` encloses the derivative between the true and the
  /// computed operand. An exact operand does nothing, also where the slope is infinite.
  static Interval effect(const Interval& slope, double error) {
    return error > 0 ? Interval(largest_magnitude_in(slope)) * Interval(error) : Interval(0);
  }

  Interval both() const { return Scalar<Interval>::hull(value, computed); }

  friend RunningFloat operator+(const RunningFloat& a, const RunningFloat& b) {
    return rounded(a.value + b.value, a.computed + b.computed, Interval(a.error) + Interval(b.error));
  }
  friend RunningFloat operator-(const RunningFloat& a) { return {-a.value, -a.computed, a.error}; }
  friend RunningFloat operator-(const RunningFloat& a, const RunningFloat& b) { return a + -b; }
  /// a' b' - a b = a' (b' - b) + (a' - a) b.
  friend RunningFloat operator*(const RunningFloat& a, const RunningFloat& b) {
    const Interval x(largest_magnitude_in(a.computed)), y(largest_magnitude_in(b.value));
    return rounded(a.value * b.value, a.computed * b.computed, x * Interval(b.error) + Interval(a.error) * y);
  }
  /// a'/b' - a/b = ((a' - a) - (b' - b) a/b)/b'.
  friend RunningFloat operator/(const RunningFloat& a, const RunningFloat& b) {
    const Interval quotient = a.value / b.value, least(smallest_magnitude_in(b.computed));
    const Interval inherited =
        (Interval(a.error) + Interval(b.error) * Interval(largest_magnitude_in(quotient))) / least;
    return rounded(quotient, a.computed / b.computed, inherited);
  }

 private:
  static constexpr double half_ulp = power_of_two(-FloatFormat::digits);  ///< of a result, relative
  static constexpr double half_least = least_of<FloatFormat> / 2;         ///< of a subnormal one

  /// What results may be rounded to: rounding is monotonic. The results themselves are kept in, because a
  /// fused multiplication and addition does not round the product. From overflow on nothing is known.
  static Interval to_float(const Interval& result) {
    const auto round = [](double x) { return static_cast<double>(NarrowResult<FloatFormat>::rounded(x)); };
    const double lower = lower_end(result), upper = upper_end(result);
    if (!(std::isfinite(round(lower)) && std::isfinite(round(upper)))) return any_number();
    return Scalar<Interval>::hull(result, span_of(round(lower), round(upper)));
  }
};

/// A function without a slope here has only its enclosures, which are wide on wide boxes.
template <>
struct Scalar<RunningFloat> {
  using T = RunningFloat;

  static T exp(const T& x) { return of(shadefit::exp, x, shadefit::exp(x.both())); }
  static T exp2(const T& x) {
    return of(shadefit::exp2, x, shadefit::exp2(x.both()) * shadefit::ln2<Interval>());
  }
  static T log(const T& x) { return of(shadefit::log, x, one() / x.both()); }
  static T log2(const T& x) { return of(shadefit::log2, x, one() / (x.both() * shadefit::ln2<Interval>())); }
  static T expm1(const T& x) { return of(shadefit::expm1, x, shadefit::exp(x.both())); }
  static T log1p(const T& x) { return of(shadefit::log1p, x, one() / (one() + x.both())); }
  static T log1p_remainder(const T& x) { return of(shadefit::log1p_remainder, x, any_number()); }
  static T sqrt(const T& x) {
    return of(shadefit::sqrt, x, one() / (Interval(2) * shadefit::sqrt(x.both())));
  }
  static T sin(const T& x) { return of(shadefit::sin, x, shadefit::cos(x.both())); }
  static T cos(const T& x) { return of(shadefit::cos, x, shadefit::sin(x.both())); }
  static T tan(const T& x) { return of(shadefit::tan, x, one() + square(shadefit::tan(x.both()))); }
  static T asin(const T& x) {
    return of(shadefit::asin, x, one() / shadefit::sqrt(one() - square(x.both())));
  }
  static T acos(const T& x) {
    return of(shadefit::acos, x, one() / shadefit::sqrt(one() - square(x.both())));
  }
  static T atan(const T& x) { return of(shadefit::atan, x, one() / (one() + square(x.both()))); }
  static T sinh(const T& x) { return of(shadefit::sinh, x, shadefit::cosh(x.both())); }
  static T cosh(const T& x) { return of(shadefit::cosh, x, shadefit::sinh(x.both())); }
  static T tanh(const T& x) { return of(shadefit::tanh, x, one() - square(shadefit::tanh(x.both()))); }
  /// 2/sqrt(pi) exp(-x^2) is at most 1.13.
  static T erf(const T& x) { return of(shadefit::erf, x, Interval(2)); }
  static T erfc(const T& x) { return of(shadefit::erfc, x, Interval(2)); }
  static T atan2(const T& y, const T& x) {
    return T::rounded(shadefit::atan2(y.value, x.value), shadefit::atan2(y.computed, x.computed),
                      any_number());
  }
  static T floor(const T& x) { return step(shadefit::floor, x); }
  static T sign(const T& x) { return step(shadefit::signum, x); }
  static T abs(const T& x) { return T::enclosed(shadefit::abs(x.value), shadefit::abs(x.computed), x.error); }

  /// The slopes of x^p are p x^(p-1) and x^p log x.
  static T power(const T& x, const T& p) {
    const Interval b = x.both(), q = p.both();
    const Interval by_x = q * shadefit::power(b, Interval(q - one()));
    const Interval by_p = shadefit::power(b, q) * shadefit::log(b);
    return T::rounded(shadefit::power(x.value, p.value), shadefit::power(x.computed, p.computed),
                      T::effect(by_x, x.error) + T::effect(by_p, p.error));
  }

  /// A condition that holds, or not, for the true and for the computed operands alike.
  static Certainty less(const T& a, const T& b) {
    const Certainty truly = shadefit::less(a.value, b.value);
    return truly == shadefit::less(a.computed, b.computed) ? truly : Certainty::unknown;
  }
  static T select(Certainty condition, const T& a, const T& b) {
    if (condition == Certainty::yes) return a;
    if (condition == Certainty::no) return b;
    return T::enclosed(hull(a.value, b.value), hull(a.computed, b.computed), unbounded_error);
  }
  /// The larger of two numbers moves by no more than one of them.
  static T max(const T& a, const T& b) {
    return T::enclosed(shadefit::max(a.value, b.value), shadefit::max(a.computed, b.computed),
                       std::fmax(a.error, b.error));
  }
  static T min(const T& a, const T& b) { return -max(-a, -b); }

  static T integer(int n) { return T::rounded_number(Interval(n)); }
  static T from_decimal(std::string_view decimal) { return T::rounded_number(constant<Interval>(decimal)); }
  static T pi() { return T::rounded_number(shadefit::pi<Interval>()); }
  static T ln2() { return T::rounded_number(shadefit::ln2<Interval>()); }

 private:
  static constexpr double unbounded_error = std::numeric_limits<double>::infinity();

  static Interval one() { return Interval(1); }
  static Interval square(const Interval& x) { return shadefit::power(x, 2); }
  static Interval hull(const Interval& a, const Interval& b) { return Scalar<Interval>::hull(a, b); }
  template <class F>
  static T of(const F& function, const T& x, const Interval& slope) {
    return T::rounded(function(x.value), function(x.computed), T::effect(slope, x.error));
  }
  template <class F>
  static T step(const F& function, const T& x) {
    return T::enclosed(function(x.value), function(x.computed), unbounded_error);
  }
};

}  // namespace shadefit
