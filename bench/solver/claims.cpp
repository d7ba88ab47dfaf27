#include <benchmark/benchmark.h>

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

void evaluate_all(benchmark::State& state) {
  for (auto _ : state) {
    Fits fits;
    benchmark::DoNotOptimize(judge_claims([](std::string_view) { return true; }, fits).data());
  }
}

}  // namespace

void register_claims() {
  benchmark::RegisterBenchmark("ledger", evaluate_all)->Unit(benchmark::kMillisecond);
  for (const Topic& topic : ledger()) {
    for (const Claim& claim : topic.claims) register_claim(claim);
  }
}

}  // namespace shadefit::bench
