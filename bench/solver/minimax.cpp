#include <benchmark/benchmark.h>

#include <string>

#include "bench/solver/benchmarks.hpp"
#include "fit/families/families.hpp"
#include "fit/least_squares/least_squares.hpp"
#include "fit/minimax/minimax_problem.hpp"

// Apart from the least-squares benchmarks: in one translation unit gcc inlines less, and the pair's
// least-squares fit takes 12.7 us instead of 7.8.
namespace shadefit::bench {
namespace {

/// The pair by its largest error, from nothing: sampling, a start by Ceres, the exchange, the polish.
void register_pair(Error error) {
  const FresnelQuadratic pair;
  const Metric metric{.norm = Norm::minimax, .error = error};
  const auto name = "minimax/fresnel-quadratic/" + std::string(shadefit::name(error));
  benchmark::RegisterBenchmark(name.c_str(), [pair, metric](benchmark::State& state) {
    MinimaxOptimum optimum;
    for (auto _ : state) {
      optimum = Minimax<FresnelQuadratic>(pair, metric, {1, 0}, {0, 1}).solve(start_of_minimax(pair, metric));
      benchmark::DoNotOptimize(optimum);
    }
    require(optimum.status == Status::converged, "a fit did not converge");
    state.counters["digits"] = optimum.digits;
    state.counters["steps"] = optimum.iterations;
  })->Unit(benchmark::kMicrosecond);
}

}  // namespace

void register_minimax() {
  register_pair(Error::absolute);
  register_pair(Error::relative);
}

}  // namespace shadefit::bench
