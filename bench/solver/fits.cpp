#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "bench/solver/benchmarks.hpp"
#include "bench/solver/problems.hpp"

namespace shadefit::bench {
namespace {

/// One pass over all problems, each from nothing: read, recorded, sampled, fitted, with its largest errors.
void register_problems(const std::string& name, const std::vector<Problem>& problems) {
  benchmark::RegisterBenchmark(("fit/" + name).c_str(), [problems](benchmark::State& state) {
    Tally tally;
    for (auto _ : state) {
      tally = {};
      for (const Problem& problem : problems) tally.add(problem.solve());
      benchmark::DoNotOptimize(tally);
    }
    tally.show(state);
    state.counters["fits"] = static_cast<double>(tally.fits);
  })->Unit(benchmark::kMicrosecond);
}

/// Exponents evenly on a logarithmic scale within 0.1 .. 1e6. Fits share nothing: each thread has its own.
void fit_on_threads(benchmark::State& state) {
  const Family& lobe = *find_family("sg-offset");
  constexpr int exponents = 1000;
  int i = state.thread_index();
  for (auto _ : state) {
    i = (i + state.threads()) % exponents;
    benchmark::DoNotOptimize(lobe.fit(std::pow(10, -1 + 7 * (i + 0.5) / exponents), {}).parameters.data());
  }
}

}  // namespace

void register_fits() {
  constexpr std::array cosine{Measure::cosine};
  register_problems("fresnel-one-term", problems("fresnel-one-term", cosine));
  register_problems("fresnel-quadratic", problems("fresnel-quadratic", cosine));
  register_problems("sg-offset-3-to-15", problems("sg-offset", cosine, "3:15:1"));
  register_problems("phong-blinn", problems("phong-blinn", cosine));
  std::vector<Problem> catalogue;
  for (const char* id : {"sg-offset", "fresnel-one-term", "fresnel-quadratic", "phong-blinn"})
    for (const Problem& problem : problems(id, measures)) catalogue.push_back(problem);
  register_problems("catalogue", catalogue);
  benchmark::RegisterBenchmark("scaling/sg-offset", fit_on_threads)
      ->ThreadRange(1, 2)
      ->UseRealTime()
      ->Unit(benchmark::kMicrosecond);
}

}  // namespace shadefit::bench
