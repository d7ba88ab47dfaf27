#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <vector>

#include "bench/solver/benchmarks.hpp"
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

/// The results of many fits.
struct Tally {
  long fits = 0;
  double sum = 0;            ///< of the first parameters
  int digits = most_digits;  ///< of the worst
  bool have_all_converged = true;

  void add(const Tally& more) {
    fits += more.fits;
    sum += more.sum;
    digits = std::min(digits, more.digits);
    have_all_converged = have_all_converged && more.have_all_converged;
  }
  void add(const Optimum& optimum) {
    add({1, optimum.parameters[0], optimum.digits, optimum.status == Status::converged});
  }

  /// The counter `digits` shows a fast wrong answer. A fit that did not converge fails the benchmark.
  void show(benchmark::State& state) const {
    require(have_all_converged, "a fit did not converge");
    state.counters["digits"] = digits;
    state.counters["per_fit"] =
        benchmark::Counter(static_cast<double>(fits),
                           benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  }
};

}  // namespace shadefit::bench
