#pragma once

#include <functional>
#include <vector>

#include "approx/cosine.hpp"
#include "fit/quadrature/substitution.hpp"
#include "fit/scalars/jet.hpp"

/// Where a function of the cosine is largest in magnitude.
namespace shadefit {

struct Extremum {
  double magnitude = 0;
  Cosine<double> at{};
};

/// Magnitudes this close to the largest count as equal to it, relative; the smallest c among them is the
/// place reported.
inline constexpr double equal_extrema = 1e-9;

/// Where a sampled search looks: 256 even places inside (0, 1), and towards either end powers of two, so that
/// a spike as narrow as 1e-12 of the domain is seen there.
std::vector<double> search_points();

/// The largest value of a function of s in [0, 1] that has no derivative to go by: the best of the
/// `search_points` and both ends, refined between its neighbours to half the digits of its place, which is
/// all that a maximum has.
double largest_sampled(const std::function<double(double)>& f);

/// A function of the cosine behind plain functions: the search is compiled once, and not for each function.
struct SearchedFunction {
  using Jet = ceres::Jet<double, 1>;

  std::function<double(const Cosine<double>&)> value;
  std::function<double(const Cosine<Jet>&)>
      slope;  ///< the derivative of what it is by what the Jet varies by
};

/// The largest |f| over the domain of the substitution. Sampled: sign changes of f' are looked for between
/// the `search_points` and refined to a root; both ends count.
Extremum largest_magnitude(const SearchedFunction& f, const Substitution& substitution);

/// The largest |f| over several panels; of equal ones the smallest c, as within a panel.
Extremum largest_magnitude(const SearchedFunction& f, const std::vector<Substitution>& panels);

/// The same, over either, of an `f` that maps a Cosine<T> to a T for double and ceres::Jet<double, 1>.
template <class F, class Places>
Extremum largest_magnitude(const F& f, const Places& places) {
  const SearchedFunction searched{[&f](const Cosine<double>& c) { return f(c); },
                                  [&f](const Cosine<SearchedFunction::Jet>& c) { return f(c).v[0]; }};
  return largest_magnitude(searched, places);
}

}  // namespace shadefit
