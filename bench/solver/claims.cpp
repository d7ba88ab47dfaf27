#include <benchmark/benchmark.h>

#include <chrono>
#include <string>

#include "bench/solver/benchmarks.hpp"
#include "fit/ledger/ledger.hpp"

namespace shadefit::bench {
namespace {

void register_claim(const Claim& claim) {
  benchmark::RegisterBenchmark(("claim/" + std::string(claim.id)).c_str(), [&claim](benchmark::State& state) {
    for (auto _ : state) {
      Fits fits;
      const Finding finding = evaluate(claim, fits);
      benchmark::DoNotOptimize(finding.evidence.data());
    }
  })->Unit(benchmark::kMillisecond);
}

/// All claims one after another; the label names the slowest, `longest_ms` is its time.
void measure_ledger(benchmark::State& state) {
  using Clock = std::chrono::steady_clock;
  double longest = 0;
  std::string_view slowest;
  for (auto _ : state) {
    longest = 0;
    Fits fits;
    for (const Topic& topic : ledger()) {
      for (const Claim& claim : topic.claims) {
        const auto start = Clock::now();
        const Finding finding = evaluate(claim, fits);
        benchmark::DoNotOptimize(finding.evidence.data());
        const double time = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
        if (time <= longest) continue;
        longest = time;
        slowest = claim.id;
      }
    }
  }
  state.counters["longest_ms"] = longest;
  state.SetLabel(std::string(slowest));
}

}  // namespace

void register_claims() {
  benchmark::RegisterBenchmark("ledger", measure_ledger)->Unit(benchmark::kMillisecond);
  for (const Topic& topic : ledger()) {
    for (const Claim& claim : topic.claims) register_claim(claim);
  }
}

}  // namespace shadefit::bench
