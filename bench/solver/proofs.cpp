#include <benchmark/benchmark.h>

#include "bench/solver/benchmarks.hpp"
#include "fit/bounds/study_certificate.hpp"
#include "fit/catalogue/published.hpp"

namespace shadefit::bench {
namespace {

StudySubject published_pair() {
  StudySubject pair{{.target = "(1 - c)^5", .form = "exp2((a c + b) c)", .over = {{"c", "0", "1"}}}, {}};
  for (const char* id : {"fresnel-quadratic-a", "fresnel-quadratic-b"}) {
    const Published& published = *find_published(id);
    pair.parameters.emplace_back(published.parameter, published.printed);
  }
  return pair;
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
