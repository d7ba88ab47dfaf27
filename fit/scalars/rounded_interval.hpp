#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "approx/scalar.hpp"
#include "fit/scalars/certainty.hpp"
#include "fit/scalars/end_arithmetics.hpp"

/// Intervals in a machine's arithmetic: all results that an operation can have for operands in given
/// intervals.
namespace shadefit {

/// All results that an arithmetic can return for operands in intervals. A result that may be NaN is the whole
/// line.
template <class Arithmetic>
class RoundedInterval {
 public:
  RoundedInterval() = default;
  explicit RoundedInterval(double operand) : RoundedInterval(operand, operand) {}
  RoundedInterval(double lower, double upper) : RoundedInterval(valid(Arithmetic::operand({lower, upper}))) {}

  /// A number of the program, not one of its variables. On a GPU the compiler may move it.
  static RoundedInterval number(double lower, double upper) {
    RoundedInterval result(lower, upper);
    result.is_number_ = true;
    return result;
  }

  static RoundedInterval everything() { return RoundedInterval(Ends{-unbounded, unbounded}); }
  /// The smallest interval that contains both.
  friend RoundedInterval hull(const RoundedInterval& a, const RoundedInterval& b) {
    return RoundedInterval(Ends{std::min(a.lower(), b.lower()), std::max(a.upper(), b.upper())});
  }

  double lower() const { return ends_.lower; }
  double upper() const { return ends_.upper; }

  friend RoundedInterval operator+(const RoundedInterval& a, const RoundedInterval& b) {
    const double moved = moved_by(a, b);
    RoundedInterval sum(valid(rounded_sum(widened(sum_of(a.ends_, b.ends_), moved))));
    if constexpr (Arithmetic::contracts) {
      if (a.is_product_) sum = hull(sum, contracted(a.product_, b.ends_, moved));
      if (b.is_product_) sum = hull(sum, contracted(b.product_, a.ends_, moved));
      sum.additions_ = a.additions_ + b.additions_ + 1;
    }
    return sum.of_numbers(a.is_number_ && b.is_number_);
  }
  friend RoundedInterval operator-(const RoundedInterval& a) {
    RoundedInterval result(negative(a.ends_));
    result.product_ = negative(a.product_);
    result.is_product_ = a.is_product_;
    result.additions_ = a.additions_;
    return result.of_numbers(a.is_number_);
  }
  friend RoundedInterval operator-(const RoundedInterval& a, const RoundedInterval& b) { return a + -b; }
  friend RoundedInterval operator*(const RoundedInterval& a, const RoundedInterval& b) {
    const Ends product = corners(a.ends_, b.ends_, [](double x, double y) { return x * y; });
    RoundedInterval result(valid(Arithmetic::basic(product)));
    if constexpr (Arithmetic::contracts) {
      result.product_ = product;
      result.is_product_ = true;
    }
    return result.of_numbers(a.is_number_ && b.is_number_);
  }
  friend RoundedInterval operator/(const RoundedInterval& a, const RoundedInterval& b) {
    if (b.lower() <= 0 && 0 <= b.upper()) return everything();
    return RoundedInterval(
        valid(Arithmetic::quotient(corners(a.ends_, b.ends_, [](double x, double y) { return x / y; }))));
  }

  /// A function of the arithmetic.
  template <Ends (*function)(Ends)>
  static RoundedInterval of(const RoundedInterval& x) {
    return RoundedInterval(valid(function(x.ends_))).of_numbers(x.is_number_);
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

  RoundedInterval of_numbers(bool is_number) const {
    RoundedInterval result = *this;
    result.is_number_ = is_number;
    return result;
  }

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
  static RoundedInterval contracted(Ends product, Ends other, double moved) {
    const Ends sum = widened(sum_of(product, other), moved);
    return RoundedInterval(valid(
        Arithmetic::basic({std::nextafter(sum.lower, -unbounded), std::nextafter(sum.upper, unbounded)})));
  }

  static Ends widened(Ends x, double by) { return by > 0 ? Ends{x.lower - by, x.upper + by} : x; }
  /// How far the sum of a number and a sum may move: see the sum of `RunningNarrow`.
  static double moved_by(const RoundedInterval& a, const RoundedInterval& b) {
    if constexpr (Arithmetic::contracts) {
      const Ends& number = a.is_number_ ? a.ends_ : b.ends_;
      const double largest = std::max(std::abs(number.lower), std::abs(number.upper));
      if (a.is_number_ != b.is_number_)
        return largest * Arithmetic::unit_roundoff * (a.additions_ + b.additions_);
    }
    return 0;
  }

  Ends ends_;
  Ends product_;  ///< the product before rounding
  bool is_product_ = false;
  bool is_number_ = false;  ///< whether no variable is in it
  int additions_ = 0;       ///< the additions of the sum that this is, without those inside its terms
};

template <class Arithmetic>
struct Scalar<RoundedInterval<Arithmetic>> {
  using T = RoundedInterval<Arithmetic>;

  static T exp(const T& x) { return T::template of<Arithmetic::exp>(x); }
  static T exp2(const T& x) { return T::template of<Arithmetic::exp2>(x); }
  static T log(const T& x) { return T::template of<Arithmetic::log>(x); }
  static T log2(const T& x) { return T::template of<Arithmetic::log2>(x); }
  static T log1p(const T& x) { return other<OutwardArithmetic::log1p>(x); }
  static T sqrt(const T& x) { return T::template of<Arithmetic::sqrt>(x); }
  static T power(const T& x, const T& p) { return T::power(x, p); }
  static T expm1(const T& x) { return other<OutwardArithmetic::expm1>(x); }
  static T log1p_remainder(const T& x) { return other<OutwardArithmetic::log1p_remainder>(x); }
  static T erf(const T& x) { return other<OutwardArithmetic::erf>(x); }
  static T erfc(const T& x) { return other<OutwardArithmetic::erfc>(x); }
  static T sin(const T& x) { return T::template of<Arithmetic::sin>(x); }
  static T cos(const T& x) { return T::template of<Arithmetic::cos>(x); }
  static T tan(const T& x) { return other<OutwardArithmetic::tan>(x); }
  static T asin(const T& x) { return other<OutwardArithmetic::asin>(x); }
  static T acos(const T& x) { return other<OutwardArithmetic::acos>(x); }
  static T atan(const T& x) { return other<OutwardArithmetic::atan>(x); }
  static T atan2(const T& y, const T& x) { return T::template of_two<Arithmetic::atan2>(y, x); }
  static T sinh(const T& x) { return other<OutwardArithmetic::sinh>(x); }
  static T cosh(const T& x) { return other<OutwardArithmetic::cosh>(x); }
  static T tanh(const T& x) { return other<OutwardArithmetic::tanh>(x); }
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

  static T integer(int n) { return number(n, true); }
  static T from_decimal(std::string_view text) {
    // Whole numbers of so many digits are doubles.
    constexpr std::size_t exact_digits = 15;
    const bool is_whole =
        text.size() <= exact_digits && text.find_first_not_of("0123456789") == std::string_view::npos;
    return number(Scalar<double>::from_decimal(text), is_whole);
  }
  static T pi() { return number(std::numbers::pi, false); }
  static T ln2() { return number(std::numbers::ln2, false); }
  static bool is_zero(const T& x) { return x.lower() == 0 && x.upper() == 0; }

 private:
  /// A function that an arithmetic makes of that of real numbers.
  template <Ends (*real)(Ends)>
  static T other(const T& x) {
    return T::template of<Arithmetic::template other<real>>(x);
  }
  static T number(double x, bool is_exact) {
    const Ends ends = Arithmetic::number(x, is_exact);
    return T::number(ends.lower, ends.upper);
  }
};

}  // namespace shadefit
