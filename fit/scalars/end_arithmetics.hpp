#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "approx/scalar.hpp"
#include "fit/scalars/gpu_model.hpp"
#include "fit/scalars/narrow_result.hpp"

/// How the ends of an interval are rounded: to a format, outward, or as a GPU may do it.
namespace shadefit {

inline constexpr double unbounded = std::numeric_limits<double>::infinity();

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
  static Ends tanh(Ends x) { return widened({std::tanh(x.lower), std::tanh(x.upper)}, 4); }
  /// It rises between its poles, where the cosine is 0.
  static Ends tan(Ends x) {
    const Ends c = cos(x);
    if (!(c.lower > 0 || c.upper < 0)) return {-unbounded, unbounded};
    return widened({std::tan(x.lower), std::tan(x.upper)}, 2);
  }
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
  template <Ends (*real)(Ends)>
  static Ends other(Ends x) {
    return real(x);
  }
  /// A number lies within half an ulp of its double.
  static Ends number(double x, bool is_exact) { return is_exact ? Ends{x, x} : widened({x, x}, 1); }

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

/// Every operation is rounded to nearest in the format, as those of `NarrowResult` are. Rounding is
/// monotonic, so the rounded ends enclose every rounded result between them.
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
  static Ends sin(Ends x) { return other<OutwardArithmetic::sin>(x); }
  static Ends cos(Ends x) { return other<OutwardArithmetic::cos>(x); }
  static Ends floor(Ends x) { return other<OutwardArithmetic::floor>(x); }
  static Ends atan2(Ends y, Ends x) { return basic(OutwardArithmetic::atan2(y, x)); }
  /// A function of the GNU C library in double, rounded. The enclosure of the real function contains what
  /// the library returns. Of an operand that may be NaN, the result may be NaN too.
  template <Ends (*real)(Ends)>
  static Ends other(Ends x) {
    return x.lower == -unbounded && x.upper == unbounded ? x : basic(real(x));
  }
  static Ends number(double x, bool) { return basic({x, x}); }

 private:
  static constexpr double slack = 0x1p-51;
};

/// A GPU that computes in a format, with the errors of `usual_gpu`. Functions, quotients and roots are made
/// in float. A narrower format may round these floats or cut them off.
template <class Format>
struct GpuArithmetic {
  static constexpr bool contracts = true;
  static constexpr double unit_roundoff = power_of_two(-Format::digits);
  static Ends operand(Ends x) { return flushed<Format>(x); }
  static Ends number(double x, bool) { return basic({x, x}); }
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
  static Ends sin(Ends x) { return wave(x, OutwardArithmetic::sin(x)); }
  static Ends cos(Ends x) { return wave(x, OutwardArithmetic::cos(x)); }
  static Ends floor(Ends x) { return OutwardArithmetic::floor(x); }
  static Ends atan2(Ends, Ends) { return {-unbounded, unbounded}; }
  /// A function about which nothing is known.
  template <Ends (*real)(Ends)>
  static Ends other(Ends) {
    return {-unbounded, unbounded};
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
  static Ends wave(Ends x, Ends exact) {
    const double own = gpu_wave_error(x, usual_gpu);
    return narrowed({exact.lower - own, exact.upper + own});
  }
  static Ends relaxed(Ends x, double relative) { return widened_by_gpu(x, relative); }
  static Ends float_exp2(Ends x) { return rounded<FloatFormat>(gpu_exp2(x, usual_gpu)); }
  static Ends float_log2(Ends x) { return rounded<FloatFormat>(gpu_log2(x, usual_gpu)); }
};

}  // namespace shadefit
