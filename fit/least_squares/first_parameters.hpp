#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "fit/least_squares/least_squares.hpp"

/// Problems of which only the first parameters are free. So a family is compiled once, and not once for each
/// number of free parameters.
namespace shadefit {

/// With 0 for the others.
template <std::size_t N, class T, std::size_t M>
std::array<T, N> padded(const std::array<T, M>& p) {
  std::array<T, N> all{};
  std::copy(p.begin(), p.end(), all.begin());
  return all;
}

template <int M, class T, int N>
SampledGradient<T, M> of_first(const SampledGradient<T, N>& all) {
  return {all.square, all.gradient.template head<M>(), all.slopes.template topLeftCorner<M, M>()};
}

/// The problem of the first M parameters.
template <int M, int N>
DescentProblem<M> of_first(const DescentProblem<N>& all) {
  if constexpr (M == N) {
    return all;
  } else {
    using Parameters = typename DescentProblem<M>::Parameters;
    return {.square = [f = all.square](const Parameters& p) { return f(padded<N>(p)); },
            .gradient = [f = all.gradient](const Parameters& p) { return of_first<M>(f(padded<N>(p))); },
            .derivatives =
                [f = all.derivatives](const Parameters& p) {
                  const auto derivatives = f(padded<N>(p));
                  return SampledDerivatives<double, M>{of_first<M>(derivatives),
                                                       derivatives.hessian.template topLeftCorner<M, M>()};
                },
            .errors =
                [f = all.errors](const Parameters& p, std::span<double> r, std::span<double> slopes) {
                  std::vector<double> of_all(r.size() * N);
                  f(padded<N>(p), r, of_all);
                  std::copy_n(of_all.begin(), slopes.size(), slopes.begin());
                },
            .weight = all.weight,
            .is_admissible = [f = all.is_admissible](const Parameters& p) { return f(padded<N>(p)); }};
  }
}

template <int M, int N>
LeastSquaresProblem<M> of_first(const LeastSquaresProblem<N>& all) {
  const auto wide = [f = all.wide](std::size_t rule, const std::array<long double, M>& p) {
    return of_first<M>(f(rule, padded<N>(p)));
  };
  return {of_first<M>(all.basin), of_first<M>(all.fine), wide, all.first};
}

template <int M, std::size_t N>
Starts<M> of_first(const std::array<std::array<double, N>, 3>& all) {
  Starts<M> starts;
  for (std::size_t i = 0; i < starts.size(); ++i)
    std::copy_n(all[i].begin(), starts[i].size(), starts[i].begin());
  return starts;
}

/// Calls `visit<M>()` for the M in 1 .. N that is `count`.
template <int N, class Visit>
auto visit_count(std::size_t count, const Visit& visit) {
  if constexpr (N > 1) {
    if (count < static_cast<std::size_t>(N)) return visit_count<N - 1>(count, visit);
  }
  return visit.template operator()<N>();
}

/// The optimum over the first `count` parameters; the others are 0.
template <int N>
Optimum<N> solve_first(const LeastSquaresProblem<N>& problem, const Starts<N>& starts, std::size_t count) {
  return visit_count<N>(count, [&]<int M>() {
    const Optimum<M> optimum = solve_least_squares<M>(of_first<M>(problem), of_first<M>(starts));
    return Optimum<N>{.parameters = padded<N>(optimum.parameters),
                      .status = optimum.status,
                      .iterations = optimum.iterations,
                      .digits = optimum.digits,
                      .rms_error = optimum.rms_error,
                      .why = optimum.why};
  });
}

/// The optimum of a descent from the first of the starts.
template <int N>
Candidate<N> descend_first(const DescentProblem<N>& problem, const Starts<N>& starts, std::size_t count) {
  return visit_count<N>(count, [&]<int M>() {
    const Candidate<M> found = common_optimum<M>(of_first<M>(starts), of_first<M>(problem), 1);
    return Candidate<N>{.parameters = padded<N>(found.parameters),
                        .iterations = found.iterations,
                        .status = found.status,
                        .why = found.why};
  });
}

}  // namespace shadefit
