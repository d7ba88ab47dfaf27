#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "approx/encoding.hpp"
#include "fit/errors/extremum.hpp"

/// The effect of a difference on a picture, in the units of a renderer: 8-bit codes, ulps of half. All
/// effects of the project are computed here: add values before and after to an `Effect`; `sentence` puts it
/// into words.
namespace shadefit {

/// A coordinate with its name: "c = 0.284", "80 degrees", "code 251". The words must outlive it: use
/// literals.
struct Coordinate {
  std::string_view before = {};  ///< the words before the number; empty: there is no coordinate
  double value = 0;
  std::string_view after = {};
};

/// One coordinate, or two: "c = 0.735, k = 3".
struct Coordinates {
  Coordinate first;
  Coordinate second = {};
};

struct Change {
  double magnitude = 0;
  Coordinates at{};
};

/// The largest changes of all values, each at its own worst place.
struct Effect {
  Change absolute;               ///< the largest |change|
  Change relative;               ///< the largest |change / value|, if the value is at least `visible`
  bool reaches_visible = false;  ///< whether a value was at least `visible`
  double half_ulps = 0;          ///< the largest |change| in units of the last place of a half
  double srgb_codes = 0;         ///< the largest |change| in 8-bit sRGB codes (a real number: 1 is one code)

  /// Adds a value that changes from `before` to `after` at a place. Of changes that are equal within
  /// `equal_extrema`, the first is kept. A change that is not finite makes `absolute` infinite.
  void show(double before, double after, const Coordinates& at);

  /// Adds the values of another effect; `beside` is added to its places.
  void include(const Effect& other, const Coordinate& beside = {});
};

/// A relative change counts if the value is at least one code of an 8-bit linear target.
inline constexpr double visible = 1.0 / 255;

/// The distance from |value| to the next half: 2^(e-10) in [2^e, 2^(e+1)), 2^-24 in the subnormals.
inline double ulp_of_half(double value) {
  const int exponent = std::max(-14, std::ilogb(std::max(std::abs(value), 0x1p-24)));
  return std::ldexp(1.0, exponent - 10);
}

/// The smallest relative change that moves a grey in [0, 1] by a whole 8-bit sRGB code: white that is darker
/// by this is sent as 254. The second reading of words like "accurate".
double change_of_one_code();

/// "c = 0.284"; near the peak, "c = 1 - 0.00031".
inline Coordinates at_cosine(const Cosine<double>& c) {
  constexpr double near = 0.005;
  const bool is_near = c.one_minus_cos > 0 && c.one_minus_cos < near;
  return is_near ? Coordinates{{"c = 1 - ", c.one_minus_cos}} : Coordinates{{"c = ", c.cos_theta}};
}

/// The effect of replacing one function of the cosine by another, the largest of each kind over the
/// `search_points` of the substitution and both ends. Both map a Cosine<double> to a value.
template <class Before, class After>
Effect sampled_effect(const Before& before, const After& after, const Substitution& substitution) {
  Effect effect;
  std::vector<double> points{0, 1};  // first: of equal changes an end is the plainer place
  const std::vector<double> inside = search_points();
  points.insert(points.end(), inside.begin(), inside.end());
  for (const double s : points) {
    const Cosine<double> c = substitution.at(s).cosine;
    effect.show(before(c), after(c), at_cosine(c));
  }
  return effect;
}

/// The same with a refined extremum of the absolute change. Both map a Cosine<T> to a T, for double and
/// ceres::Jet<double, 1>.
template <class Before, class After>
Effect effect_between(const Before& before, const After& after, const Substitution& substitution) {
  Effect effect = sampled_effect(before, after, substitution);
  const Extremum largest =
      largest_magnitude([&]<class T>(const Cosine<T>& c) { return T(after(c) - before(c)); }, substitution);
  effect.absolute = {largest.magnitude, at_cosine(largest.at)};
  return effect;
}

/// "c = 0.735, k = 3": whole numbers in full, others to three digits.
std::string words(const Coordinates& place);

/// "moves the curve by up to 0.0017 codes of 8-bit sRGB (absolute: 3.7e-06 at c = 0.284; relative: 0.00013 at
/// c = 0.0684; half float: 0.48 ulps)", or "none" if nothing moved. Each number is the largest of its kind.
/// The lead stands before it: "at k = 5 the form moves ..".
std::string sentence(const Effect& effect, std::string_view what = "the curve", std::string_view lead = {});

/// The parts as sentences, without the last full stop: {"x is 1", "the rest is 2"} gives "x is 1. The rest is
/// 2". Leaves out parts that are empty or "none"; "none" where nothing is left.
std::string sentences(const std::vector<std::string>& parts);

}  // namespace shadefit
