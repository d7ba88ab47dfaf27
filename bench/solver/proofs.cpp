#include <benchmark/benchmark.h>

#include <string>

#include "approx/fresnel.hpp"
#include "bench/solver/benchmarks.hpp"
#include "fit/bounds/family_subject.hpp"

namespace shadefit::bench {
namespace {

StudySubject published_pair() {
  FamilySubject pair{.family = "fresnel-quadratic", .parameters = {}};
  for (const Published& published : published_constants()) {
    if (published.family == pair.family) pair.parameters.emplace_back(published.parameter, published.printed);
  }
  return in_words(pair);
}

/// Bounds with this relative width. The counter `boxes` is the size of the proof.
void measure_certify(benchmark::State& state, double width) {
  const StudySubject pair = published_pair();
  CertifiedStudy made;
  for (auto _ : state) {
    made = certify_study(pair, width);
    benchmark::DoNotOptimize(made.certificate.upper);
  }
  require(made.is_reached, "the width was not reached");
  state.counters["boxes"] = static_cast<double>(count_boxes(made.certificate));
}

void measure_verify(benchmark::State& state) {
  const StudyCertificate certificate = certify_study(published_pair(), 1e-9).certificate;
  for (auto _ : state) require(reason_to_refuse(certificate).empty(), "a certificate was refused");
}

}  // namespace

void register_proofs() {
  benchmark::RegisterBenchmark("certify/published-pair/1e-9", measure_certify, 1e-9)
      ->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("certify/published-pair/1e-12", measure_certify, 1e-12)
      ->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("verify/published-pair/1e-9", measure_verify)->Unit(benchmark::kMillisecond);
}

}  // namespace shadefit::bench
