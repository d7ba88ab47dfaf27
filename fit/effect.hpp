#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "approx/encoding.hpp"
#include "fit/extremum.hpp"

/// What a change of constants does to the curve, in the units that a renderer programmer feels.
namespace shadefit {

struct Effect {
  Extremum absolute;      ///< the largest |change|
  double relative = 0;    ///< the largest |change / value|, where the value is at least `visible`
  double half_ulps = 0;   ///< the largest |change| in units of the last place of a half
  double srgb_codes = 0;  ///< the largest |change| in 8-bit sRGB codes (a real number: 1 is one code)
};

/// A relative change is stated where the value is at least one code of an 8-bit linear target.
inline constexpr double visible = 1.0 / 255;

/// The distance from |value| to the next half: 2^(e-10) in [2^e, 2^(e+1)), 2^-24 in the subnormals.
inline double half_ulp(double value) {
  const int exponent = std::max(-14, std::ilogb(std::max(std::abs(value), 0x1p-24)));
  return std::ldexp(1.0, exponent - 10);
}

/// The effect of going from parameters `from` to `to`, each unit at its own worst place. Absolute: a refined
/// extremum; the others: the largest over the `search_points` and both ends.
template <class F, std::size_t N>
Effect effect_of_change(const F& family, const Domain& domain, const std::array<double, N>& from,
                        const std::array<double, N>& to) {
  const Substitution substitution({.measure = Measure::cosine, .domain = domain}, family.shape());
  const auto change = [&]<class T>(const Cosine<T>& c) {
    std::array<T, N> p, q;
    for (std::size_t i = 0; i < N; ++i) {
      p[i] = lift<T>(from[i]);
      q[i] = lift<T>(to[i]);
    }
    const auto sample = family.sample(c);
    return family.form(sample, q) - family.form(sample, p);
  };

  Effect effect;
  effect.absolute = largest_magnitude(change, substitution);
  std::vector<double> points = search_points();
  points.insert(points.end(), {0.0, 1.0});
  for (const double s : points) {
    const auto sample = family.sample(substitution.at(s).cosine);
    const double before = family.form(sample, from), after = family.form(sample, to);
    const double step = std::abs(after - before);
    if (before >= visible) effect.relative = std::max(effect.relative, step / before);
    effect.half_ulps = std::max(effect.half_ulps, step / half_ulp(before));
    effect.srgb_codes = std::max(effect.srgb_codes, std::abs(srgb_code(after) - srgb_code(before)));
  }
  return effect;
}

}  // namespace shadefit
