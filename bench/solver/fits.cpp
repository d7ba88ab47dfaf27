#include <benchmark/benchmark.h>

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

/// Times one pass over all problems of a tuple of vectors; each has a `solve`.
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
  tally.show(state);
  state.counters["fits"] = static_cast<double>(tally.fits);
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
