#pragma once

#include <functional>
#include <vector>

#include "approx/cosine.hpp"
#include "fit/quadrature/substitution.hpp"
#include "fit/scalars/jet.hpp"

/// The largest magnitude of a function of the cosine, and its place.
namespace shadefit {

struct Extremum {
  double magnitude = 0;
  Cosine<double> at{};
};

/// Magnitudes within this relative distance of the largest count as equal. The smallest c among them is
/// reported.
inline constexpr double equal_extrema = 1e-9;

/// The places of a sampled search: 256 even places inside (0, 1), and powers of two towards both ends, so
/// that a spike of 1e-12 of the domain is seen there.
std::vector<double> search_points();

/// The largest value of a function of s in [0, 1] without a derivative: the best of the `search_points` and
/// both ends, refined between its neighbours. The place gets half of the digits of a double: a maximum has no
/// more.
double largest_sampled(const std::function<double(double)>& f);

/// A function of the cosine behind plain functions, so that the search is compiled once.
struct SearchedFunction {
  using Jet = ceres::Jet<double, 1>;

  std::function<double(const Cosine<double>&)> value;
  std::function<double(const Cosine<Jet>&)> slope;  ///< its derivative
};

/// The largest |f| over the domain of the substitution. Sampled: sign changes of f' between the
/// `search_points` are refined to roots; both ends count.
Extremum largest_magnitude(const SearchedFunction& f, const Substitution& substitution);

/// The same for an `f` that maps a Cosine<T> to a T for double and ceres::Jet<double, 1>.
template <class F>
Extremum largest_magnitude(const F& f, const Substitution& substitution) {
  const SearchedFunction searched{[&f](const Cosine<double>& c) { return f(c); },
                                  [&f](const Cosine<SearchedFunction::Jet>& c) { return f(c).v[0]; }};
  return largest_magnitude(searched, substitution);
}

}  // namespace shadefit
