#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <vector>

#include "bench/solver/benchmarks.hpp"
#include "fit/catalogue/family.hpp"
#include "fit/steps/digits.hpp"
#include "fit/support/sweep.hpp"

/// The fits of the benchmarks.
namespace shadefit::bench {

struct Problem {
  const Family* family;
  Setting setting;
  Metric metric;

  Fit solve() const { return family->fit(setting, metric); }
};

/// A family under each measure, at each exponent of a sweep, else of its own; once per measure if it has no
/// exponent.
inline std::vector<Problem> problems(std::string_view id, std::span<const Measure> measures,
                                     std::string_view sweep = {}) {
  const Family& family = *find_family(id);
  std::vector<Problem> result;
  for (const Measure measure : measures) {
    const Metric metric{.measure = measure};
    if (!family.has_exponent()) {
      result.push_back({&family, {}, metric});
      continue;
    }
    for (const double exponent : parse_sweep(sweep.empty() ? family.sweep : sweep))
      result.push_back({&family, exponent, metric});
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
  void add(const Fit& fit) { add({1, fit.parameters[0], fit.digits, fit.status == Status::converged}); }

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
