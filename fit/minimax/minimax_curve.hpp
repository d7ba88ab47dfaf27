#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "fit/minimax/minimax.hpp"
#include "fit/scalars/jet.hpp"

/// A curve of a minimax problem from one template.
namespace shadefit {

template <class T, std::size_t N, class Values>
std::array<T, N> first_as(const Values& values) {
  std::array<T, N> first;
  for (std::size_t i = 0; i < N; ++i) first[i] = lift<T>(values[i]);
  return first;
}

/// The curve of `error(panel, s, parameters)`. s in [0, 1] on that panel has the scalar T; the parameters,
/// the first N, have the scalar P, which is T or has derivatives by them; the result is a P. `slope_across`
/// and `wide_slope` are empty. `places` are those of the problem, and must not move while the curve is in
/// use.
template <std::size_t N = most_parameters, class Error>
MinimaxCurve curve_of_error(const Error& error, const std::vector<SearchPlace>& places) {
  return {.everywhere =
              [error, &places](const MinimaxParameters& p, std::span<double> values) {
                const auto q = first_as<double, N>(p);
                for (std::size_t i = 0; i < places.size(); ++i)
                  values[i] = error(places[i].panel, places[i].s, q);
              },
          .along =
              [error](const SearchPlace& place, const MinimaxParameters& p) {
                using First = ceres::Jet<double, 1>;
                using Second = ceres::Jet<First, 1>;
                Second s(First(place.s, 0));
                s.v[0] = First(1.0);
                const Second value = error(place.panel, s, first_as<Second, N>(p));
                return Along{value.a.a, value.a.v[0], value.v[0].v[0]};
              },
          .across =
              [error](const SearchPlace& place, const MinimaxParameters& p, Unknowns& gradient) {
                using Jet = ceres::Jet<double, static_cast<int>(N)>;
                std::array<Jet, N> q;
                for (std::size_t i = 0; i < N; ++i) q[i] = Jet(p[i], static_cast<int>(i));
                const Jet value = error(place.panel, place.s, q);
                for (std::size_t i = 0; i < N; ++i) gradient[i] = value.v[static_cast<int>(i)];
                return value.a;
              },
          .wide =
              [error](const SearchPlace& place, const WideParameters& p) {
                return error(place.panel, static_cast<long double>(place.s), first_as<long double, N>(p));
              }};
}

}  // namespace shadefit
