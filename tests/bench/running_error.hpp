#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "fit/proof/interval.hpp"
#include "fit/proof/interval_ends.hpp"
#include "fit/scalars/gpu_model.hpp"
#include "fit/scalars/narrow_result.hpp"
#include "tests/bench/box.hpp"

/// Proven bounds of the rounding error of a formula: running error analysis with intervals.
namespace shadefit {

/// The rounding of a format's operations, relative to the exact result: of a basic operation, of a function,
/// and the absolute error that underflow adds.
struct Rounding {
  double basic;
  double quotient;
  double root;
  double function;  ///< of a GPU that of exp2
  double underflow;
  const GpuModel* gpu = nullptr;  ///< its log2; exp and pow are computed with exp2 and log2

  bool operator==(const Rounding&) const = default;
};

/// The true value of a quantity, enclosed, and a bound of |computed - true|. It carries the rounding of the
/// operations; an untouched operand has none.
///
/// Each operation bounds the effect of its operands' errors on its true result, over the whole intervals: by
/// its derivative or, for exp, by exp(a + b) = exp(a) exp(b). Then it adds its own rounding of the computed
/// value. Source: Higham 2002, "Accuracy and Stability of Numerical Algorithms", 2nd edition, section 3.3.
struct RunningError {
  Interval value;
  double error = 0;
  const Rounding* rounding = nullptr;

  /// An operand: the number itself, or on a GPU zero if it is subnormal.
  static RunningError operand(const Interval& value, const Rounding& rounding) {
    return {value, rounding.gpu != nullptr ? rounding.underflow : 0, &rounding};
  }
  static const Rounding& rounding_of(const RunningError& a, const RunningError& b) {
    return a.rounding != nullptr ? *a.rounding : *b.rounding;
  }

  /// A result whose operands contribute `inherited`, rounded by `relative`.
  static RunningError rounded(const Interval& value, const Interval& inherited, double relative,
                              const Rounding& rounding) {
    const double before = largest_magnitude_in(inherited);
    const Interval all = Interval(before) +
                         Interval(relative) * (Interval(largest_magnitude_in(value)) + Interval(before)) +
                         Interval(rounding.underflow);
    return {value, largest_magnitude_in(all), &rounding};
  }

  friend RunningError operator+(const RunningError& a, const RunningError& b) {
    const Rounding& r = rounding_of(a, b);
    return rounded(a.value + b.value, Interval(a.error) + Interval(b.error), r.basic, r);
  }
  friend RunningError operator-(const RunningError& a) { return {-a.value, a.error, a.rounding}; }
  friend RunningError operator-(const RunningError& a, const RunningError& b) { return a + -b; }
  friend RunningError operator*(const RunningError& a, const RunningError& b) {
    const Rounding& r = rounding_of(a, b);
    const Interval x(largest_magnitude_in(a.value)), y(largest_magnitude_in(b.value));
    const Interval ea(a.error), eb(b.error);
    return rounded(a.value * b.value, x * eb + y * ea + ea * eb, r.basic, r);
  }
  /// |(a + ea)/(b + eb) - a/b| <= (|ea| + |a/b| |eb|)/(|b| - |eb|).
  friend RunningError operator/(const RunningError& a, const RunningError& b) {
    const Rounding& r = rounding_of(a, b);
    const Interval quotient = a.value / b.value;
    const Interval rest = Interval(smallest_magnitude_in(b.value)) - Interval(b.error);
    if (!(lower_end(rest) > 0)) return unknown(quotient, r);
    const Interval size(largest_magnitude_in(quotient));
    return rounded(quotient, (Interval(a.error) + size * Interval(b.error)) / rest, r.quotient, r);
  }

  static RunningError unknown(const Interval& value, const Rounding& rounding) {
    return {value, std::numeric_limits<double>::infinity(), &rounding};
  }
};

/// The operations that the forms use.
template <>
struct Scalar<RunningError> {
  using T = RunningError;

  /// 2^(y + e) - 2^y = 2^y (2^e - 1).
  static T exp2(const T& x) { return by_law(x, scaled(x.error)); }

  static T exp(const T& x) {
    const Rounding& r = *x.rounding;
    if (r.gpu == nullptr) return by_law_of(shadefit::exp(x.value), Interval(x.error), r);
    // exp2 of the rounded product with the rounded log2 e
    const T product = x * T{Interval(1) / shadefit::ln2<Interval>(), 0, &r};
    const Interval off =
        shadefit::expm1(scaled(product.error + 2 * r.basic * largest_magnitude_in(product.value)));
    const Interval value = shadefit::exp(x.value);
    return T::rounded(value, value * off, r.function, r);
  }

  /// |log2(x + e) - log2(x)| <= e/((x - e) ln 2).
  static T log2(const T& x) {
    const Rounding& r = *x.rounding;
    const Interval value = shadefit::log2(x.value);
    const Interval rest = Interval(lower_end(x.value)) - Interval(x.error);
    if (!(lower_end(rest) > 0)) return T::unknown(value, r);
    return rounded_log2(value, x, Interval(x.error) / (rest * shadefit::ln2<Interval>()), r);
  }

  /// x^p = exp2(p log2 x), x > 0: its relative change is exp of the change of p log x.
  static T power(const T& x, const T& p) {
    const Rounding& r = T::rounding_of(x, p);
    const Interval value = shadefit::power(x.value, p.value);
    T logarithm{shadefit::log2(x.value), 0, &r};
    const Interval rest = Interval(lower_end(x.value)) - Interval(x.error);
    if (!(lower_end(rest) > 0)) return T::unknown(value, r);
    logarithm.error = largest_magnitude_in(Interval(x.error) / (rest * shadefit::ln2<Interval>()));
    if (r.gpu != nullptr) logarithm = rounded_log2(logarithm.value, x, Interval(logarithm.error), r);
    const Interval l(largest_magnitude_in(logarithm.value)), q(largest_magnitude_in(p.value));
    Interval off = l * Interval(p.error) + (q + Interval(p.error)) * Interval(logarithm.error);
    if (r.gpu != nullptr)
      off += Interval(r.basic) * (l + Interval(logarithm.error)) * (q + Interval(p.error));
    return T::rounded(value, value * shadefit::expm1(off * shadefit::ln2<Interval>()), r.function, r);
  }

  /// |sqrt(x + e) - sqrt(x)| <= e/sqrt(x).
  static T sqrt(const T& x) {
    const Rounding& r = *x.rounding;
    const Interval value = shadefit::sqrt(x.value);
    if (!(lower_end(value) > 0)) return T::unknown(value, r);
    return T::rounded(value, Interval(x.error) / Interval(lower_end(value)), r.root, r);
  }

  static T integer(int n) { return {Interval(n), 0, nullptr}; }

 private:
  /// log2 of the computed x, whose value differs by `inherited` from that of the true one.
  static T rounded_log2(const Interval& value, const T& x, const Interval& inherited, const Rounding& r) {
    if (r.gpu == nullptr) return T::rounded(value, inherited, r.function, r);
    const Ends computed{lower_end(Interval(x.value - Interval(x.error))),
                        upper_end(Interval(x.value + Interval(x.error)))};
    // gpu_log2_error rounds some doubles, far below the last bit that a float has.
    const Interval own = Interval(gpu_log2_error(computed, *r.gpu)) * Interval(1 + 0x1p-40);
    return T::rounded(value, inherited + own, 0, r);
  }
  static Interval scaled(double error) { return Interval(error) * shadefit::ln2<Interval>(); }
  static T by_law(const T& x, const Interval& change) {
    return by_law_of(shadefit::exp2(x.value), change, *x.rounding);
  }
  static T by_law_of(const Interval& value, const Interval& change, const Rounding& r) {
    return T::rounded(value, value * shadefit::expm1(change), r.function, r);
  }
};

/// The arithmetic of a CPU. An operation has an error of half an ulp, at most 2^-p of its result. Functions
/// have half an ulp in float, by the contract of `--round`, and one ulp in double, by the manual of the GNU C
/// library.
inline constexpr Rounding float_rounding{0x1p-24, 0x1p-24, 0x1p-24, 0x1p-24, least_of<FloatFormat>};
inline constexpr Rounding double_rounding{0x1p-53, 0x1p-53, 0x1p-52, 0x1p-52, 0x1p-1074};
/// See `usual_gpu`.
inline constexpr Rounding gpu_float_rounding{float_ulp / 2,
                                             usual_gpu.quotient_ulps* float_ulp,
                                             usual_gpu.root_ulps* float_ulp,
                                             usual_gpu.exp2_ulps* float_ulp,
                                             least_normal_of<FloatFormat>,
                                             &usual_gpu};

/// A bound of the rounding error of a form over a domain. Boxes are cut until the largest bound is within a
/// twentieth of the largest value at single places, or until there are too many. `error` maps a box's
/// cosines, enclosed, to a bound there.
template <class Error>
double bound_of_rounding(const Error& error, const Domain& domain) {
  using Part = std::pair<double, Box>;
  const auto by_bound = [](const Part& a, const Part& b) { return a.first < b.first; };
  std::priority_queue<Part, std::vector<Part>, decltype(by_bound)> parts(by_bound);
  double reached = 0;
  const auto at = [&](const Box& box) {
    const double bound = error(cosine_at(box.side, span_of(box.lower, box.upper)));
    return std::isnan(bound) ? std::numeric_limits<double>::infinity() : bound;
  };
  const auto add = [&](const Box& box) {
    parts.push({at(box), box});
    const double centre = box.lower + (box.upper - box.lower) / 2;
    reached = std::max(reached, at({box.side, centre, centre}));
  };
  for (const Box& box : boxes_of(domain)) add(box);
  constexpr double near = 1.05;
  constexpr std::size_t most_parts = 2000;
  while (parts.top().first > near * reached && parts.size() < most_parts) {
    const Box box = parts.top().second;
    const double centre = box.lower + (box.upper - box.lower) / 2;
    if (!(box.lower < centre && centre < box.upper)) break;
    parts.pop();
    add({box.side, box.lower, centre});
    add({box.side, centre, box.upper});
  }
  return parts.top().first;
}

}  // namespace shadefit
