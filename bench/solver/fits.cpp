#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <string>
#include <tuple>
#include <vector>

#include "bench/solver/benchmarks.hpp"
#include "bench/solver/problems.hpp"
#include "fit/families/families.hpp"
#include "fit/least_squares/least_squares.hpp"

namespace shadefit::bench {
namespace {

/// The results of one pass.
struct Tally {
  int fits = 0;
  int digits = most_digits;  ///< of the worst
  bool have_all_converged = true;

  void add(const Optimum& optimum) {
    ++fits;
    digits = std::min(digits, optimum.digits);
    have_all_converged = have_all_converged && optimum.status == Status::converged;
  }
};

/// Times one pass over all problems of a tuple of vectors; each has a `solve`. The counter `digits` shows a
/// fast wrong answer. A fit that did not converge fails the benchmark.
template <class Problems>
void measure(benchmark::State& state, const Problems& problems) {
  Tally tally;
  const auto solve_all = [&](const auto& of_one_family) {
    for (const auto& problem : of_one_family) tally.add(problem.solve());
  };
  for (auto _ : state) {
    tally = {};
    std::apply([&](const auto&... family) { (solve_all(family), ...); }, problems);
    benchmark::DoNotOptimize(tally);
  }
  if (!tally.have_all_converged) state.SkipWithError("a fit did not converge");
  state.counters["digits"] = tally.digits;
  state.counters["fits"] = tally.fits;
  state.counters["per_fit"] = benchmark::Counter(
      tally.fits, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template <class F>
auto sampled(const std::vector<Problem<F>>& problems) {
  std::vector<LeastSquares<F>> result;
  for (const auto& problem : problems) result.push_back(problem.sampled());
  return result;
}

/// Each twice: `ready`, with the nodes and samples made outside the timed part, as is usual for other
/// solvers, and `from-nothing`.
template <class... F>
void register_both(const std::string& name, const std::vector<Problem<F>>&... problems) {
  const auto register_one = [&](const char* way, const auto& all) {
    benchmark::RegisterBenchmark(("fit/" + name + way).c_str(), [all](benchmark::State& state) {
      measure(state, all);
    })->Unit(benchmark::kMicrosecond);
  };
  register_one("/ready", std::tuple(sampled(problems)...));
  register_one("/from-nothing", std::tuple(problems...));
}

}  // namespace

void register_fits() {
  constexpr std::array cosine{Measure::cosine};
  register_both("fresnel-one-term", problems<FresnelOneTerm>(cosine));
  register_both("fresnel-quadratic", problems<FresnelQuadratic>(cosine));
  register_both("sg-offset-3-to-15", problems<SgOffset>(cosine, "3:15:1"));
  register_both("phong-blinn", problems<PhongBlinn>(cosine));
  register_both("catalogue", problems<SgOffset>(measures), problems<FresnelOneTerm>(measures),
                problems<FresnelQuadratic>(measures), problems<PhongBlinn>(measures));
}

}  // namespace shadefit::bench
