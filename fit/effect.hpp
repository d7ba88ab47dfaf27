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

/// The effect of going from one function of the cosine to another over the domain of the substitution, each
/// unit at its own worst place. Absolute: a refined extremum; the others: the largest over the
/// `search_points` and both ends. Both map a Cosine<T> to a T, for double and ceres::Jet<double, 1>.
template <class Before, class After>
Effect effect_between(const Before& before, const After& after, const Substitution& substitution) {
  Effect effect;
  effect.absolute =
      largest_magnitude([&]<class T>(const Cosine<T>& c) { return T(after(c) - before(c)); }, substitution);
  std::vector<double> points = search_points();
  points.insert(points.end(), {0.0, 1.0});
  for (const double s : points) {
    const Cosine<double> c = substitution.at(s).cosine;
    const double old_value = before(c), new_value = after(c);
    const double step = std::abs(new_value - old_value);
    if (old_value >= visible) effect.relative = std::max(effect.relative, step / old_value);
    effect.half_ulps = std::max(effect.half_ulps, step / half_ulp(old_value));
    effect.srgb_codes = std::max(effect.srgb_codes, std::abs(srgb_code(new_value) - srgb_code(old_value)));
  }
  return effect;
}

/// The effect of going from parameters `from` to `to`.
template <class F, std::size_t N>
Effect effect_of_change(const F& family, const Domain& domain, const std::array<double, N>& from,
                        const std::array<double, N>& to) {
  const auto curve = [&](const std::array<double, N>& parameters) {
    return [&]<class T>(const Cosine<T>& c) {
      std::array<T, N> p;
      for (std::size_t i = 0; i < N; ++i) p[i] = lift<T>(parameters[i]);
      return family.form(family.sample(c), p);
    };
  };
  return effect_between(curve(from), curve(to),
                        Substitution({.measure = Measure::cosine, .domain = domain}, family.shape()));
}

/// "moves the curve by at most 3.7e-06 (at c = 0.284), 0.00013 of its value, ..", or "none".
std::string sentence(const Effect& effect);

}  // namespace shadefit
