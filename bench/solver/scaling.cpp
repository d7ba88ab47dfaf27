#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "bench/solver/benchmarks.hpp"
#include "bench/solver/problems.hpp"
#include "fit/input/parallel.hpp"

namespace shadefit::bench {
namespace {

/// Of `count` exponents, evenly on a logarithmic scale within 0.1 .. 1e6, the one in place `i`. Computed on
/// demand: a list would take memory in proportion to `count`.
double exponent(long i, long count) {
  return std::pow(10, -1 + 7 * (static_cast<double>(i) + 0.5) / static_cast<double>(count));
}

/// Every `stride`-th exponent from `first` on: so that each thread has small and large ones, whose costs
/// differ.
Tally fit_share(long first, long stride, long count) {
  const Family& family = *find_family("sg-offset");
  Tally tally;
  for (long i = first; i < count; i += stride) tally.add(family.fit(exponent(i, count), {}));
  return tally;
}

/// Fits share nothing: each thread has its own exponents.
Tally fit_all(long count, long threads) {
  std::vector<Tally> parts(static_cast<std::size_t>(threads));
  for_each_in_parallel(
      parts.size(),
      [&](std::size_t t, const Checkpoint&) { parts[t] = fit_share(static_cast<long>(t), threads, count); },
      {.threads = static_cast<unsigned>(threads)});
  Tally all;
  for (const Tally& part : parts) all.add(part);
  return all;
}

void measure(benchmark::State& state) {
  const long count = state.range(0), threads = state.range(1);
  Tally tally;
  for (auto _ : state) {
    tally = fit_all(count, threads);
    benchmark::DoNotOptimize(tally);
  }
  tally.show(state);
}

}  // namespace

void register_scaling() {
  auto* scaling = benchmark::RegisterBenchmark("scaling/sg-offset", measure);
  scaling->ArgNames({"fits", "threads"})
      ->Unit(benchmark::kMillisecond)
      ->MeasureProcessCPUTime()
      ->UseRealTime();
  for (long fits = 1; fits <= 100'000; fits *= 10) {
    for (const long threads : {1, 2}) scaling->Args({fits, threads});
  }
}

}  // namespace shadefit::bench
