#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "fit/proof/interval.hpp"
#include "fit/proof/interval_ends.hpp"
#include "fit/scalars/narrow_result.hpp"
#include "tests/bench/box.hpp"

/// Proven bounds of the rounding error of a formula: running error analysis with intervals.
namespace shadefit {

/// The rounding of a sum or a product in a format: relative to the exact result, and the absolute error that
/// underflow adds.
struct Rounding {
  double relative, underflow;
};

/// The true value of a quantity, enclosed, and a bound of |computed - true|. It carries the rounding of the
/// operations; an untouched operand has none. Each operation bounds the effect of its operands' errors on its
/// true result, over the whole intervals, and adds its own rounding of the computed value. Source: Higham
/// 2002, "Accuracy and Stability of Numerical Algorithms", 2nd edition, section 3.3.
struct RunningError {
  Interval value;
  double error = 0;
  const Rounding* rounding = nullptr;

  /// A result whose operands contribute `inherited`.
  static RunningError rounded(const Interval& value, const Interval& inherited, const Rounding& rounding) {
    const double before = largest_magnitude_in(inherited);
    const Interval all =
        Interval(before) +
        Interval(rounding.relative) * (Interval(largest_magnitude_in(value)) + Interval(before)) +
        Interval(rounding.underflow);
    return {value, largest_magnitude_in(all), &rounding};
  }

  friend RunningError operator+(const RunningError& a, const RunningError& b) {
    const Rounding& r = a.rounding != nullptr ? *a.rounding : *b.rounding;
    return rounded(a.value + b.value, Interval(a.error) + Interval(b.error), r);
  }
  friend RunningError operator*(const RunningError& a, const RunningError& b) {
    const Rounding& r = a.rounding != nullptr ? *a.rounding : *b.rounding;
    const Interval x(largest_magnitude_in(a.value)), y(largest_magnitude_in(b.value));
    const Interval ea(a.error), eb(b.error);
    return rounded(a.value * b.value, x * eb + y * ea + ea * eb, r);
  }
};

template <>
struct Scalar<RunningError> {
  static RunningError integer(int n) { return {Interval(n), 0, nullptr}; }
};

/// The arithmetic of a CPU: half an ulp, at most 2^-p of its result.
inline constexpr Rounding float_rounding{0x1p-24, least_of<FloatFormat>};
inline constexpr Rounding double_rounding{0x1p-53, 0x1p-1074};

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
