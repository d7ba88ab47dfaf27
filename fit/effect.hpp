#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
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

/// The effect of a change over the domain of the substitution, each unit at its own worst place. Absolute: a
/// refined extremum; the others: the largest over the `search_points` and both ends. `values` maps a
/// Cosine<T> to the value before and the value after, an std::array<T, 2>, for double and ceres::Jet<double,
/// 1>.
template <class Values>
Effect effect_over(const Values& values, const Substitution& substitution) {
  Effect effect;
  effect.absolute = largest_magnitude(
      [&]<class T>(const Cosine<T>& c) {
        const std::array<T, 2> value = values(c);
        return T(value[1] - value[0]);
      },
      substitution);
  std::vector<double> points = search_points();
  points.insert(points.end(), {0.0, 1.0});
  for (const double s : points) {
    const auto [before, after] = values(substitution.at(s).cosine);
    const double step = std::abs(after - before);
    if (before >= visible) effect.relative = std::max(effect.relative, step / before);
    effect.half_ulps = std::max(effect.half_ulps, step / half_ulp(before));
    effect.srgb_codes = std::max(effect.srgb_codes, std::abs(srgb_code(after) - srgb_code(before)));
  }
  return effect;
}

/// The effect of going from one function of the cosine to another; both map a Cosine<T> to a T.
template <class Before, class After>
Effect effect_between(const Before& before, const After& after, const Substitution& substitution) {
  return effect_over(
      [&]<class T>(const Cosine<T>& c) {
        return std::array<T, 2>{before(c), after(c)};
      },
      substitution);
}

/// The effect of going from parameters `from` to `to`: a place is sampled once for both.
template <class F, std::size_t N>
Effect effect_of_change(const F& family, const Domain& domain, const std::array<double, N>& from,
                        const std::array<double, N>& to) {
  const auto values = [&]<class T>(const Cosine<T>& c) {
    std::array<T, N> p, q;
    for (std::size_t i = 0; i < N; ++i) {
      p[i] = lift<T>(from[i]);
      q[i] = lift<T>(to[i]);
    }
    const auto sample = family.sample(c);
    return std::array<T, 2>{family.form(sample, p), family.form(sample, q)};
  };
  return effect_over(values, Substitution({.measure = Measure::cosine, .domain = domain}, family.shape()));
}

/// "moves the curve by at most 3.7e-06 (at c = 0.284), 0.00013 of its value, ..", or "none".
std::string sentence(const Effect& effect);

}  // namespace shadefit
