#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "approx/scalar.hpp"
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
  static Ends quotient(Ends x) { return basic(x); }
  static Ends exp(Ends x) { return widened({std::exp(x.lower), std::exp(x.upper)}, 2); }
  static Ends exp2(Ends x) { return widened({std::exp2(x.lower), std::exp2(x.upper)}, 2); }
  static Ends log(Ends x) { return widened({std::log(x.lower), std::log(x.upper)}, 2); }
  static Ends log2(Ends x) { return widened({std::log2(x.lower), std::log2(x.upper)}, 2); }
  static Ends log1p(Ends x) { return widened({std::log1p(x.lower), std::log1p(x.upper)}, 4); }
  static Ends sqrt(Ends x) { return widened({std::sqrt(x.lower), std::sqrt(x.upper)}, 1); }
  static Ends power(Ends corners) { return widened(corners, 2); }

 private:
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

  double lower() const { return ends_.lower; }
  double upper() const { return ends_.upper; }

  friend RoundedInterval operator+(const RoundedInterval& a, const RoundedInterval& b) {
    RoundedInterval sum(valid(Arithmetic::basic(sum_of(a.ends_, b.ends_))));
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

  /// A rising function of the arithmetic.
  template <Ends (*function)(Ends)>
  static RoundedInterval rising(const RoundedInterval& x) {
    return RoundedInterval(valid(function(x.ends_)));
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

  static RoundedInterval everything() { return RoundedInterval(Ends{-unbounded, unbounded}); }
  static Ends valid(Ends x) {
    return std::isnan(x.lower) || std::isnan(x.upper) ? Ends{-unbounded, unbounded} : x;
  }
  static Ends negative(Ends x) { return {-x.upper, -x.lower}; }
  static Ends sum_of(Ends a, Ends b) { return {a.lower + b.lower, a.upper + b.upper}; }
  static RoundedInterval hull(const RoundedInterval& a, const RoundedInterval& b) {
    return RoundedInterval(Ends{std::min(a.lower(), b.lower()), std::max(a.upper(), b.upper())});
  }
  template <class Operation>
  static Ends corners(Ends a, Ends b, const Operation& operation) {
    const double p = operation(a.lower, b.lower), q = operation(a.lower, b.upper),
                 r = operation(a.upper, b.lower), s = operation(a.upper, b.upper);
    if (std::isnan(p) || std::isnan(q) || std::isnan(r) || std::isnan(s)) return {-unbounded, unbounded};
    return {std::min({p, q, r, s}), std::max({p, q, r, s})};
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

  static T exp(const T& x) { return T::template rising<Arithmetic::exp>(x); }
  static T exp2(const T& x) { return T::template rising<Arithmetic::exp2>(x); }
  static T log(const T& x) { return T::template rising<Arithmetic::log>(x); }
  static T log2(const T& x) { return T::template rising<Arithmetic::log2>(x); }
  static T log1p(const T& x) { return T::template rising<Arithmetic::log1p>(x); }
  static T sqrt(const T& x) { return T::template rising<Arithmetic::sqrt>(x); }
  static T power(const T& x, const T& p) { return T::power(x, p); }
  static T integer(int n) { return T(n); }
};

}  // namespace shadefit
