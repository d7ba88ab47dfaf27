#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>

#include "approx/scalar.hpp"
#include "fit/scalars/certainty.hpp"
#include "fit/scalars/gpu_model.hpp"
#include "fit/scalars/narrow_result.hpp"

/// Intervals in a machine's arithmetic: all results that an operation can have for operands in given
/// intervals.
namespace shadefit {

inline constexpr double unbounded = std::numeric_limits<double>::infinity();

/// Every operation is rounded to nearest in the format. Rounding is monotonic, so the rounded ends enclose
/// every rounded result between them.
template <class Format>
struct CorrectArithmetic {
  static constexpr bool contracts = false;
  static double round(double x) { return static_cast<double>(NarrowResult<Format>::rounded(x)); }
  static Ends operand(Ends x) { return x; }
  static Ends basic(Ends x) { return {round(x.lower), round(x.upper)}; }
  static Ends quotient(Ends x) { return basic(x); }
  static Ends exp(Ends x) { return basic({std::exp(x.lower), std::exp(x.upper)}); }
  static Ends exp2(Ends x) { return basic({std::exp2(x.lower), std::exp2(x.upper)}); }
  static Ends log(Ends x) { return basic({std::log(x.lower), std::log(x.upper)}); }
  static Ends log2(Ends x) { return basic({std::log2(x.lower), std::log2(x.upper)}); }
  static Ends sqrt(Ends x) { return basic({std::sqrt(x.lower), std::sqrt(x.upper)}); }
  /// x^p of a positive x, between the least and the largest value at the corners. pow in double may be off by
  /// an ulp, and then neighbours need not be in order.
  static Ends power(Ends corners) {
    return basic({corners.lower * (1 - slack), corners.upper * (1 + slack)});
  }

 private:
  static constexpr double slack = 0x1p-51;
};

/// Real arithmetic, enclosed in doubles: + - * / and sqrt are within half an ulp, the functions of the GNU C
/// library within one, log1p within two (its manual, "Errors in Math Functions", x86_64). An ulp is at most
/// 2^-52 of a number, or the least subnormal.
struct OutwardArithmetic {
  static constexpr bool contracts = false;
  static Ends operand(Ends x) { return x; }
  static Ends basic(Ends x) { return widened(x, 1); }
  /// A sum of doubles that is 0 is exact. So 1 - x is not negative up to x = 1.
  static Ends sum(Ends x) {
    const Ends wide = widened(x, 1);
    return {x.lower == 0 ? 0 : wide.lower, x.upper == 0 ? 0 : wide.upper};
  }
  static Ends quotient(Ends x) { return basic(x); }
  static Ends exp(Ends x) { return widened({std::exp(x.lower), std::exp(x.upper)}, 2); }
  static Ends exp2(Ends x) { return widened({std::exp2(x.lower), std::exp2(x.upper)}, 2); }
  static Ends log(Ends x) { return widened({std::log(x.lower), std::log(x.upper)}, 2); }
  static Ends log2(Ends x) { return widened({std::log2(x.lower), std::log2(x.upper)}, 2); }
  static Ends expm1(Ends x) { return widened({std::expm1(x.lower), std::expm1(x.upper)}, 2); }
  static Ends log1p(Ends x) { return widened({std::log1p(x.lower), std::log1p(x.upper)}, 4); }
  static Ends sqrt(Ends x) { return widened({std::sqrt(x.lower), std::sqrt(x.upper)}, 1); }
  static Ends power(Ends corners) { return widened(corners, 2); }
  static Ends asin(Ends x) { return widened({std::asin(x.lower), std::asin(x.upper)}, 2); }
  static Ends acos(Ends x) { return widened({std::acos(x.upper), std::acos(x.lower)}, 2); }
  static Ends atan(Ends x) { return widened({std::atan(x.lower), std::atan(x.upper)}, 2); }
  static Ends sinh(Ends x) { return widened({std::sinh(x.lower), std::sinh(x.upper)}, 4); }
  static Ends erf(Ends x) { return widened({std::erf(x.lower), std::erf(x.upper)}, 2); }
  static Ends erfc(Ends x) { return widened({std::erfc(x.upper), std::erfc(x.lower)}, 10); }
  static Ends floor(Ends x) { return {std::floor(x.lower), std::floor(x.upper)}; }
  static Ends cosh(Ends x) {
    const double least = x.lower <= 0 && 0 <= x.upper ? 0 : std::min(std::abs(x.lower), std::abs(x.upper));
    return widened({std::cosh(least), std::cosh(std::max(-x.lower, x.upper))}, 4);
  }
  static Ends sin(Ends x) { return wave(x, {std::sin(x.lower), std::sin(x.upper)}, std::numbers::pi / 2); }
  static Ends cos(Ends x) { return wave(x, {std::cos(x.lower), std::cos(x.upper)}, 0); }
  /// Where it may cross the cut of the angle, left of the origin, every angle.
  static Ends atan2(Ends y, Ends x) {
    if (y.lower <= 0 && 0 <= y.upper && x.lower <= 0)
      return widened({-std::numbers::pi, std::numbers::pi}, 1);
    const double p = std::atan2(y.lower, x.lower), q = std::atan2(y.lower, x.upper),
                 r = std::atan2(y.upper, x.lower), s = std::atan2(y.upper, x.upper);
    return widened({std::min({p, q, r, s}), std::max({p, q, r, s})}, 2);
  }
  /// It rises to its top, 0 at x = 0, and falls from there.
  static Ends log1p_remainder(Ends x) {
    const double p = Scalar<double>::log1p_remainder(x.lower), q = Scalar<double>::log1p_remainder(x.upper);
    const bool has_top = x.lower <= 0 && 0 <= x.upper;
    return widened({std::min(p, q), has_top ? 0 : std::max(p, q)}, 8);
  }
  /// The number of a decimal text lies within half an ulp of its double.
  static Ends nearby(Ends x) { return widened(x, 1); }

 private:
  /// A sine from its values at the ends. It is 1 at `top`, and repeats.
  static Ends wave(Ends x, Ends at_ends, double top) {
    constexpr double turn = 2 * std::numbers::pi;
    const auto reaches = [&](double phase) {
      const double from = (x.lower - phase) / turn, to = (x.upper - phase) / turn;
      const double rounding = 0x1p-50 * (1 + std::max(std::abs(from), std::abs(to)));
      return !(std::floor(to + rounding) < std::ceil(from - rounding));
    };
    const double low = std::min(at_ends.lower, at_ends.upper), high = std::max(at_ends.lower, at_ends.upper);
    return widened({reaches(top + turn / 2) ? -1 : low, reaches(top) ? 1 : high}, 2);
  }
  static Ends widened(Ends x, double ulps) { return {-outward(-x.lower, ulps), outward(x.upper, ulps)}; }
  /// A lower end that has overflowed is the largest double, not infinity.
  static double outward(double x, double ulps) {
    if (x == -unbounded) return -std::numeric_limits<double>::max();
    return x + ulps * (std::abs(x) * 0x1p-52 + std::numeric_limits<double>::denorm_min());
  }
};

/// A GPU that computes in a format, with the errors of `usual_gpu`. Functions, quotients and roots are made
/// in float. A narrower format may round these floats or cut them off.
template <class Format>
struct GpuArithmetic {
  static constexpr bool contracts = true;
  static Ends operand(Ends x) { return flushed<Format>(x); }
  static Ends basic(Ends x) { return rounded<Format>(x); }
  static Ends quotient(Ends x) { return narrowed(relaxed(x, usual_gpu.quotient_ulps * float_ulp)); }
  static Ends exp2(Ends x) { return narrowed(float_exp2(x)); }
  static Ends log2(Ends x) { return narrowed(float_log2(x)); }
  /// exp2(x log2 e): the product of two floats, each rounded.
  static Ends exp(Ends x) {
    constexpr double log2_of_e = 1.4426950408889634;
    return narrowed(float_exp2(relaxed({x.lower * log2_of_e, x.upper * log2_of_e}, float_ulp)));
  }
  /// log2(x) ln 2, likewise.
  static Ends log(Ends x) {
    const Ends y = float_log2(x);
    const double ln2 = Scalar<double>::ln2();
    return narrowed(relaxed({y.lower * ln2, y.upper * ln2}, float_ulp));
  }
  static Ends sqrt(Ends x) {
    return narrowed(relaxed({std::sqrt(x.lower), std::sqrt(x.upper)}, usual_gpu.root_ulps * float_ulp));
  }
  static Ends power_by_logarithm(Ends x, Ends p) {
    return narrowed(rounded<FloatFormat>(gpu_power(x, p, usual_gpu)));
  }

 private:
  template <class F>
  static Ends rounded(Ends x) {
    const auto round = [](double v) { return static_cast<double>(NarrowResult<F>::rounded(v)); };
    return flushed<F>({round(x.lower), round(x.upper)});
  }
  static Ends narrowed(Ends x) {
    const Ends nearest = rounded<Format>(x);
    if constexpr (Format::digits == FloatFormat::digits) return nearest;
    const auto cut = [](double v) { return static_cast<double>(NarrowResult<Format>::cut_off(v)); };
    return flushed<Format>({std::min(nearest.lower, cut(x.lower)), std::max(nearest.upper, cut(x.upper))});
  }
  /// A subnormal number may have become zero.
  template <class F>
  static Ends flushed(Ends x) {
    if (0 < x.lower && x.lower < least_normal_of<F>) x.lower = 0;
    if (-least_normal_of<F> < x.upper && x.upper < 0) x.upper = 0;
    return x;
  }
  static Ends relaxed(Ends x, double relative) { return widened_by_gpu(x, relative); }
  static Ends float_exp2(Ends x) { return rounded<FloatFormat>(gpu_exp2(x, usual_gpu)); }
  static Ends float_log2(Ends x) { return rounded<FloatFormat>(gpu_log2(x, usual_gpu)); }
};

/// All results that an arithmetic can return for operands in intervals. A result that may be NaN is the whole
/// line.
template <class Arithmetic>
class RoundedInterval {
 public:
  RoundedInterval() = default;
  explicit RoundedInterval(double operand) : RoundedInterval(operand, operand) {}
  RoundedInterval(double lower, double upper) : RoundedInterval(valid(Arithmetic::operand({lower, upper}))) {}

  static RoundedInterval everything() { return RoundedInterval(Ends{-unbounded, unbounded}); }
  /// The smallest interval that contains both.
  friend RoundedInterval hull(const RoundedInterval& a, const RoundedInterval& b) {
    return RoundedInterval(Ends{std::min(a.lower(), b.lower()), std::max(a.upper(), b.upper())});
  }

  double lower() const { return ends_.lower; }
  double upper() const { return ends_.upper; }

  friend RoundedInterval operator+(const RoundedInterval& a, const RoundedInterval& b) {
    RoundedInterval sum(valid(rounded_sum(sum_of(a.ends_, b.ends_))));
    if constexpr (Arithmetic::contracts) {
      if (a.is_product_) sum = hull(sum, contracted(a.product_, b.ends_));
      if (b.is_product_) sum = hull(sum, contracted(b.product_, a.ends_));
    }
    return sum;
  }
  friend RoundedInterval operator-(const RoundedInterval& a) {
    RoundedInterval result(negative(a.ends_));
    result.product_ = negative(a.product_);
    result.is_product_ = a.is_product_;
    return result;
  }
  friend RoundedInterval operator-(const RoundedInterval& a, const RoundedInterval& b) { return a + -b; }
  friend RoundedInterval operator*(const RoundedInterval& a, const RoundedInterval& b) {
    const Ends product = corners(a.ends_, b.ends_, [](double x, double y) { return x * y; });
    RoundedInterval result(valid(Arithmetic::basic(product)));
    if constexpr (Arithmetic::contracts) {
      result.product_ = product;
      result.is_product_ = true;
    }
    return result;
  }
  friend RoundedInterval operator/(const RoundedInterval& a, const RoundedInterval& b) {
    if (b.lower() <= 0 && 0 <= b.upper()) return everything();
    return RoundedInterval(
        valid(Arithmetic::quotient(corners(a.ends_, b.ends_, [](double x, double y) { return x / y; }))));
  }

  /// A function of the arithmetic.
  template <Ends (*function)(Ends)>
  static RoundedInterval of(const RoundedInterval& x) {
    return RoundedInterval(valid(function(x.ends_)));
  }
  template <Ends (*function)(Ends, Ends)>
  static RoundedInterval of_two(const RoundedInterval& a, const RoundedInterval& b) {
    return RoundedInterval(valid(function(a.ends_, b.ends_)));
  }
  /// x^p, x >= 0: monotonic in each operand, so it lies between its values at the corners.
  static RoundedInterval power(const RoundedInterval& x, const RoundedInterval& p) {
    if (x.lower() < 0) return everything();
    if constexpr (requires { Arithmetic::power_by_logarithm(x.ends_, p.ends_); }) {
      return RoundedInterval(valid(Arithmetic::power_by_logarithm(x.ends_, p.ends_)));
    } else {
      const auto pow = [](double a, double b) { return std::pow(a, b); };
      return RoundedInterval(valid(Arithmetic::power(corners(x.ends_, p.ends_, pow))));
    }
  }

 private:
  explicit RoundedInterval(Ends ends) : ends_(ends) {}

  static Ends valid(Ends x) {
    return std::isnan(x.lower) || std::isnan(x.upper) ? Ends{-unbounded, unbounded} : x;
  }
  static Ends negative(Ends x) { return {-x.upper, -x.lower}; }
  static Ends rounded_sum(Ends x) {
    if constexpr (requires { Arithmetic::sum(x); }) {
      return Arithmetic::sum(x);
    } else {
      return Arithmetic::basic(x);
    }
  }
  static Ends sum_of(Ends a, Ends b) { return {a.lower + b.lower, a.upper + b.upper}; }
  template <class Operation>
  static Ends corners(Ends a, Ends b, const Operation& operation) {
    const double p = operation(a.lower, b.lower), q = operation(a.lower, b.upper),
                 r = operation(a.upper, b.lower), s = operation(a.upper, b.upper);
    // The sum is NaN too where some are -infinity and others infinity: the interval is everything then too.
    if (std::isnan(p + q + r + s)) return {-unbounded, unbounded};
    return {std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s))};
  }
  /// A product and a sum with one rounding. The sum in double may be rounded too: its neighbours enclose it.
  static RoundedInterval contracted(Ends product, Ends other) {
    const Ends sum = sum_of(product, other);
    return RoundedInterval(valid(
        Arithmetic::basic({std::nextafter(sum.lower, -unbounded), std::nextafter(sum.upper, unbounded)})));
  }

  Ends ends_;
  Ends product_;  ///< the product before rounding
  bool is_product_ = false;
};

template <class Arithmetic>
struct Scalar<RoundedInterval<Arithmetic>> {
  using T = RoundedInterval<Arithmetic>;

  static T exp(const T& x) { return T::template of<Arithmetic::exp>(x); }
  static T exp2(const T& x) { return T::template of<Arithmetic::exp2>(x); }
  static T log(const T& x) { return T::template of<Arithmetic::log>(x); }
  static T log2(const T& x) { return T::template of<Arithmetic::log2>(x); }
  static T log1p(const T& x) { return T::template of<Arithmetic::log1p>(x); }
  static T sqrt(const T& x) { return T::template of<Arithmetic::sqrt>(x); }
  static T power(const T& x, const T& p) { return T::power(x, p); }
  static T expm1(const T& x) { return T::template of<Arithmetic::expm1>(x); }
  static T log1p_remainder(const T& x) { return T::template of<Arithmetic::log1p_remainder>(x); }
  static T erf(const T& x) { return T::template of<Arithmetic::erf>(x); }
  static T erfc(const T& x) { return T::template of<Arithmetic::erfc>(x); }
  static T sin(const T& x) { return T::template of<Arithmetic::sin>(x); }
  static T cos(const T& x) { return T::template of<Arithmetic::cos>(x); }
  static T tan(const T& x) { return sin(x) / cos(x); }
  static T asin(const T& x) { return T::template of<Arithmetic::asin>(x); }
  static T acos(const T& x) { return T::template of<Arithmetic::acos>(x); }
  static T atan(const T& x) { return T::template of<Arithmetic::atan>(x); }
  static T atan2(const T& y, const T& x) { return T::template of_two<Arithmetic::atan2>(y, x); }
  static T sinh(const T& x) { return T::template of<Arithmetic::sinh>(x); }
  static T cosh(const T& x) { return T::template of<Arithmetic::cosh>(x); }
  static T tanh(const T& x) { return integer(1) - integer(2) / (exp(x + x) + integer(1)); }
  static T floor(const T& x) { return T::template of<Arithmetic::floor>(x); }

  static Certainty less(const T& a, const T& b) {
    return a.upper() < b.lower()    ? Certainty::yes
           : a.lower() >= b.upper() ? Certainty::no
                                    : Certainty::unknown;
  }
  static T select(Certainty condition, const T& a, const T& b) {
    return condition == Certainty::yes ? a : condition == Certainty::no ? b : hull(a, b);
  }
  static T min(const T& a, const T& b) { return -max(-a, -b); }
  static T max(const T& a, const T& b) {
    return T(std::max(a.lower(), b.lower()), std::max(a.upper(), b.upper()));
  }

  static T integer(int n) { return T(n); }
  static T from_decimal(std::string_view text) {
    return T::template of<Arithmetic::nearby>(T(Scalar<double>::from_decimal(text)));
  }
  static T pi() { return T::template of<Arithmetic::nearby>(T(std::numbers::pi)); }
  static T ln2() { return T::template of<Arithmetic::nearby>(T(std::numbers::ln2)); }
  static bool is_zero(const T& x) { return x.lower() == 0 && x.upper() == 0; }
};

}  // namespace shadefit
