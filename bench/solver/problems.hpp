#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "fit/least_squares/least_squares.hpp"
#include "fit/quadrature/metric.hpp"
#include "fit/support/sweep.hpp"

/// The fits of the benchmarks.
namespace shadefit::bench {

template <class F>
struct Problem {
  F family;
  Metric metric;

  auto sampled() const { return LeastSquares<F>(family, metric); }
  auto solve() const { return solve_least_squares(family, metric); }
};

/// A family under each measure, at each exponent of a sweep; once per measure if it has no exponent.
template <class F>
std::vector<Problem<F>> problems(std::span<const Measure> measures, std::string_view sweep = F::info.sweep) {
  std::vector<Problem<F>> result;
  for (const Measure measure : measures) {
    const Metric metric{.measure = measure};
    if constexpr (requires(F f) { f.exponent; }) {
      for (const double exponent : parse_sweep(sweep)) result.push_back({F{{exponent}}, metric});
    } else {
      result.push_back({F{}, metric});
    }
  }
  return result;
}

}  // namespace shadefit::bench
