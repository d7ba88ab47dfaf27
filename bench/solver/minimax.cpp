#include <benchmark/benchmark.h>

#include <string>

#include "bench/solver/benchmarks.hpp"
#include "fit/catalogue/family.hpp"

namespace shadefit::bench {
namespace {

/// The pair by its largest error, from nothing: a start by Ceres, the exchange, the polish.
void register_pair(Error error) {
  const Family& pair = *find_family("fresnel-quadratic");
  const Metric metric{.norm = Norm::minimax, .error = error};
  const auto name = "minimax/fresnel-quadratic/" + std::string(shadefit::name(error));
  benchmark::RegisterBenchmark(name.c_str(), [&pair, metric](benchmark::State& state) {
    Fit fit;
    for (auto _ : state) {
      fit = pair.fit({}, metric);
      benchmark::DoNotOptimize(fit);
    }
    require(fit.status == Status::converged, "a fit did not converge");
    state.counters["digits"] = fit.digits;
  })->Unit(benchmark::kMicrosecond);
}

}  // namespace

void register_minimax() {
  register_pair(Error::absolute);
  register_pair(Error::relative);
}

}  // namespace shadefit::bench
