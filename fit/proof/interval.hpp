#pragma once

#include <mpfi.h>

#include <boost/multiprecision/mpfi.hpp>
#include <functional>
#include <string>

#include "approx/scalar.hpp"
#include "fit/scalars/certainty.hpp"

/// The adapter of MPFI intervals, the arithmetic of the proofs. Every result contains all true results.
namespace shadefit {

/// An interval with 50-digit ends, rounded outward by each operation. Expression templates are off.
using Interval = boost::multiprecision::number<boost::multiprecision::mpfi_float_backend<50>,
                                               boost::multiprecision::et_off>;

/// MPFI's own functions are called directly: Boost 1.74 lacks some, its comparisons terminate the process
/// when they cannot be decided, and its pow throws at zero. An end that is NaN (the root of [-1, 4]) makes
/// the whole result NaN. Otherwise MPFR's max would drop the NaN and MPFI's comparison would treat it as
/// equal.
template <>
struct Scalar<Interval> {
  static Interval exp(const Interval& x) { return apply(mpfi_exp, x); }
  static Interval exp2(const Interval& x) { return apply(mpfi_exp2, x); }
  static Interval log(const Interval& x) { return apply(mpfi_log, x); }
  static Interval log2(const Interval& x) { return apply(mpfi_log2, x); }
  static Interval expm1(const Interval& x) { return apply(mpfi_expm1, x); }
  static Interval log1p(const Interval& x) { return apply(mpfi_log1p, x); }
  static Interval sqrt(const Interval& x) { return apply(mpfi_sqrt, x); }
  static Interval sin(const Interval& x) { return apply(mpfi_sin, x); }
  static Interval cos(const Interval& x) { return apply(mpfi_cos, x); }
  static Interval tan(const Interval& x) { return apply(mpfi_tan, x); }
  static Interval asin(const Interval& x) { return apply(mpfi_asin, x); }
  static Interval acos(const Interval& x) { return apply(mpfi_acos, x); }
  static Interval atan(const Interval& x) { return apply(mpfi_atan, x); }
  static Interval atan2(const Interval& y, const Interval& x) {
    const Interval result = apply(mpfi_atan2, y, x);
    // Left of the origin the angle jumps at y = 0, where it is pi. MPFI forgets that value if y <= 0.
    const bool forgets_pi = mpfi_is_nonpos(y.backend().data()) > 0 && mpfi_has_zero(y.backend().data()) > 0 &&
                            mpfi_is_nonneg(x.backend().data()) <= 0;
    return forgets_pi ? hull(result, pi()) : result;
  }
  static Interval sinh(const Interval& x) { return apply(mpfi_sinh, x); }
  static Interval cosh(const Interval& x) { return apply(mpfi_cosh, x); }
  static Interval tanh(const Interval& x) { return apply(mpfi_tanh, x); }
  static Interval abs(const Interval& x) { return apply(mpfi_abs, x); }

  static Interval erf(const Interval& x) {
    return rising(x, [](mpfr_ptr y, mpfr_srcptr end, mpfr_rnd_t round) { mpfr_erf(y, end, round); });
  }
  static Interval erfc(const Interval& x) {
    return rising(-x, [](mpfr_ptr y, mpfr_srcptr end, mpfr_rnd_t round) {
      mpfr_neg(y, end, MPFR_RNDN);  // exact
      mpfr_erfc(y, y, round);
    });
  }
  static Interval floor(const Interval& x) {
    return rising(x, [](mpfr_ptr y, mpfr_srcptr end, mpfr_rnd_t) { mpfr_floor(y, end); });
  }

  /// log1p(x) - x rises up to x = 0 and falls from there, so its ends lie at the ends of x, or at the top 0.
  static Interval log1p_remainder(const Interval& x) {
    const Interval low = lower(x), high = upper(x);
    const Interval ends = hull(log1p(low) - low, log1p(high) - high);
    return is_zero_inside(x) ? hull(ends, integer(0)) : ends;
  }

  /// x^n: an even power of an interval around zero is not negative.
  static Interval integer_power(const Interval& x, int n) {
    if (n < 0) return integer(1) / integer_power(x, -n);
    if (n == 0) return integer(1);
    const Interval root = integer_power(x, n / 2);
    const Interval even = apply(mpfi_sqr, root);
    return n % 2 == 0 ? even : n == 1 ? x : even * x;
  }

  /// x^p = exp(p log x), x >= 0; log 0 = -infinity gives 0 for p > 0.
  static Interval power(const Interval& x, const Interval& p) { return exp(p * log(x)); }

  static Certainty less(const Interval& a, const Interval& b) {
    if (is_nan(a) || is_nan(b)) return Certainty::unknown;
    if (mpfi_cmp(a.backend().data(), b.backend().data()) < 0) return Certainty::yes;
    const bool never = mpfr_cmp(&a.backend().data()->left, &b.backend().data()->right) >= 0;
    return never ? Certainty::no : Certainty::unknown;
  }
  static Interval select(Certainty condition, const Interval& a, const Interval& b) {
    return condition == Certainty::yes ? a : condition == Certainty::no ? b : hull(a, b);
  }
  static Interval min(const Interval& a, const Interval& b) { return -max(-a, -b); }
  /// The ends of max(a, b) are the maxima of the ends.
  static Interval max(const Interval& a, const Interval& b) {
    if (is_nan(a) || is_nan(b)) return nan();
    Interval result;
    auto* r = result.backend().data();
    mpfr_max(&r->left, &a.backend().data()->left, &b.backend().data()->left, MPFR_RNDD);
    mpfr_max(&r->right, &a.backend().data()->right, &b.backend().data()->right, MPFR_RNDU);
    return result;
  }

  static Interval integer(int n) { return Interval(n); }
  static Interval from_decimal(std::string_view decimal) {
    Interval result;
    if (mpfi_set_str(result.backend().data(), std::string(decimal).c_str(), 10) != 0) {
      throw std::invalid_argument("not a decimal number: '" + std::string(decimal) + "'");
    }
    return result;
  }
  static Interval pi() { return apply(mpfi_const_pi); }
  static Interval ln2() { return apply(mpfi_const_log2); }

  static constexpr auto in_place(std::plus<> /*of*/) { return &mpfi_add; }
  static constexpr auto in_place(std::minus<> /*of*/) { return &mpfi_sub; }
  static constexpr auto in_place(std::multiplies<> /*of*/) { return &mpfi_mul; }
  static constexpr auto in_place(std::divides<> /*of*/) { return &mpfi_div; }
  /// result = a + b and so on, without a new interval. The result may be one of the operands.
  template <class Operation>
  requires requires(Operation operation) { in_place(operation); }
  static void put(Interval& result, Operation operation, const Interval& a, const Interval& b) {
    in_place(operation)(result.backend().data(), a.backend().data(), b.backend().data());
  }

  /// sum += a b, without a new interval for the product.
  static void add_product(Interval& sum, const Interval& a, const Interval& b, Interval& product) {
    mpfi_mul(product.backend().data(), a.backend().data(), b.backend().data());
    mpfi_add(sum.backend().data(), sum.backend().data(), product.backend().data());
  }

  /// Whether x is exactly 0. `==` of two intervals would terminate the process if it cannot be decided.
  static bool is_zero(const Interval& x) { return mpfi_is_zero(x.backend().data()) > 0; }

  /// The smallest interval that contains both; NaN if either is NaN (a function left its domain).
  static Interval hull(const Interval& a, const Interval& b) {
    return is_nan(a) || is_nan(b) ? nan() : apply(mpfi_union, a, b);
  }

 private:
  /// MPFI lacks some rising functions. Their ends come from the ends of x, by MPFR's directed rounding.
  template <class Function>
  static Interval rising(const Interval& x, const Function& function) {
    if (is_nan(x)) return nan();
    free_constants_with_the_thread();
    Interval result;
    auto* r = result.backend().data();
    function(&r->left, &x.backend().data()->left, MPFR_RNDD);
    function(&r->right, &x.backend().data()->right, MPFR_RNDU);
    return result;
  }
  /// What one of MPFI's functions makes of intervals.
  template <class Function, class... Intervals>
  static Interval apply(const Function& function, const Intervals&... x) {
    free_constants_with_the_thread();
    Interval result;
    function(result.backend().data(), x.backend().data()...);
    return result;
  }
  /// MPFR keeps the digits of pi and log 2 for each thread, and loses them when the thread ends.
  static void free_constants_with_the_thread() {
    struct Freed {
      ~Freed() { mpfr_free_cache2(MPFR_FREE_LOCAL_CACHE); }
    };
    thread_local const Freed freed;
    static_cast<void>(freed);
  }
  static Interval lower(const Interval& x) { return at(x.backend().data()->left); }
  static Interval upper(const Interval& x) { return at(x.backend().data()->right); }
  static Interval at(const __mpfr_struct& end) {
    Interval result;
    mpfi_set_fr(result.backend().data(), &end);
    return result;
  }
  static bool is_nan(const Interval& x) { return mpfi_nan_p(x.backend().data()) != 0; }
  static Interval nan() {
    Interval result;
    mpfr_set_nan(&result.backend().data()->left);
    mpfr_set_nan(&result.backend().data()->right);
    return result;
  }
  static bool is_zero_inside(const Interval& x) { return mpfi_has_zero(x.backend().data()) > 0; }
};

}  // namespace shadefit
