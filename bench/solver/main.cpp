#include <benchmark/benchmark.h>

#include <cstdio>
#include <exception>

#include "bench/solver/benchmarks.hpp"

/// Exit code: 0; 1 if a benchmark failed, if the filter matches none, or for an unknown argument.
int main(int argc, char** argv) try {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  shadefit::bench::register_fits();
  shadefit::bench::register_claims();
  shadefit::bench::register_proofs();
  shadefit::bench::register_studies();
  shadefit::bench::register_process();
  const bool has_run = benchmark::RunSpecifiedBenchmarks() > 0;
  benchmark::Shutdown();
  return has_run ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "shadefit_bench: %s\n", error.what());
  return 1;
}
