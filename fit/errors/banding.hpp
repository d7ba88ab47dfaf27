#pragma once

#include <algorithm>
#include <bitset>
#include <cmath>
#include <vector>

#include "approx/encoding.hpp"

/// Bands: rounding turns a smooth highlight into steps.
namespace shadefit {

struct Banding {
  int codes = 0;    ///< how many of the 256 8-bit sRGB codes are shown
  double step = 0;  ///< the largest jump beyond what the exact curve does there, in such codes
};

namespace detail {

/// The distance of a curve's values at two cosines, in 8-bit sRGB codes.
template <class Curve>
double step_between(const Curve& curve, double a, double b) {
  return std::abs(srgb_code(curve(b)) - srgb_code(curve(a)));
}

/// The jump of a computed curve between two cosines, less the step of the exact curve. The interval is
/// halved, and the half with the larger jump is kept, until the exact curve moves by less than 0.01 of a code
/// in it, or its ends are neighbouring floats. Returns `least` if the jump is not larger than that.
template <class Computed, class Exact>
double jump_between(const Computed& computed, const Exact& exact, double a, double b, double least) {
  constexpr double still = 0.01;
  for (;;) {
    const double step = step_between(computed, a, b);
    if (step <= least) return least;
    const double own = step_between(exact, a, b);
    const double middle = static_cast<double>(static_cast<float>(a + (b - a) / 2));
    if (own <= still || middle == a || middle == b) return std::max(least, step - own);
    (step_between(computed, a, middle) > step_between(computed, middle, b) ? b : a) = middle;
  }
}

}  // namespace detail

/// The banding of a computed curve over ordered samples of the cosine, compared with the exact curve. Both
/// map a cosine (a float) to a linear value with peak 1. A constant as `exact` says that each sample stands
/// for an interval of a continuous highlight, in which the exact curve has no step. With a function, a jump
/// between two samples is narrowed down.
template <class Computed, class Exact>
Banding banding(const std::vector<double>& cosines, const Computed& computed, const Exact& exact,
                double least = 0) {
  Banding found{.codes = 0, .step = least};
  std::bitset<256> codes;
  double last = -1, last_code = 0;
  for (std::size_t i = 0; i < cosines.size(); ++i) {
    const double value = computed(cosines[i]);
    if (value == last) continue;
    const double code = srgb_code(value);
    codes.set(static_cast<std::size_t>(std::lround(code)));
    if (i > 0 && std::abs(code - last_code) > found.step)
      found.step = detail::jump_between(computed, exact, cosines[i - 1], cosines[i], found.step);
    last = value;
    last_code = code;
  }
  found.codes = static_cast<int>(codes.count());
  return found;
}

/// Every half in [0.5, 1], ascending: 1025 of them, 2^-11 apart.
inline std::vector<double> halves_near_the_peak() {
  std::vector<double> halves;
  for (int i = 1024; i <= 2048; ++i) halves.push_back(std::ldexp(i, -11));
  return halves;
}

/// `count` steps of a power of two, each exact in float, over the highlight of c^k: from 1 down to at least
/// 1 - 10/k, where it has fallen below exp(-10), a seventh of an 8-bit code, but not below c = 0.5.
/// Ascending; count a power of two up to 2^13, k in [1, 4096].
inline std::vector<double> floats_over_the_highlight(double exponent, int count) {
  const double width = std::min(0.5, std::exp2(std::ceil(std::log2(10 / exponent))));
  std::vector<double> cosines;
  for (int i = count; i >= 0; --i) cosines.push_back(1 - width * i / count);
  return cosines;
}

}  // namespace shadefit
