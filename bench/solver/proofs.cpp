#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "approx/fresnel.hpp"
#include "bench/solver/benchmarks.hpp"
#include "fit/fit.hpp"
#include "fit/proof/certificate.hpp"
#include "fit/support/sweep.hpp"

namespace shadefit::bench {
namespace {

Subject published_pair() {
  Subject pair{.family = "fresnel-quadratic", .parameters = {}};
  for (const Published& published : fresnel_published) {
    if (published.family == pair.family) pair.parameters.emplace_back(published.parameter, published.printed);
  }
  return pair;
}

/// Times `measure`, in milliseconds.
template <class Measure>
void register_proof(const std::string& name, const Measure& measure) {
  benchmark::RegisterBenchmark(name.c_str(), measure)->Unit(benchmark::kMillisecond);
}

/// Bounds with this relative width. The counter `boxes` is the size of the proof.
void register_width(const std::string& name, const Subject& subject, double width) {
  register_proof("certify/" + name, [subject, width](benchmark::State& state) {
    Certified made;
    for (auto _ : state) {
      made = certify(subject, width);
      benchmark::DoNotOptimize(made.certificate.upper);
    }
    if (!made.is_reached) state.SkipWithError("the width was not reached");
    state.counters["boxes"] =
        static_cast<double>(made.certificate.horizon.size() + made.certificate.peak.size());
  });
}

/// Every fit of the catalogue: each family at each exponent of its own sweep under every measure.
std::vector<Fit> catalogue() {
  std::vector<Fit> fits;
  for (const Measure measure : measures) {
    for (const FittableFamily& family : fittable_families()) {
      for (const double k : family.has_exponent() ? parse_sweep(family.info.sweep) : std::vector{0.0})
        fits.push_back(family.fit(Setting(k), {.measure = measure}));
    }
  }
  return fits;
}

}  // namespace

void register_proofs() {
  register_width("published-pair/1e-9", published_pair(), 1e-9);
  register_width("published-pair/1e-12", published_pair(), 1e-12);
  register_proof("certify/catalogue/1e-9", [](benchmark::State& state) {
    const std::vector<Fit> fits = catalogue();
    for (auto _ : state) {
      for (const Fit& fit : fits) {
        if (!certify(subject_of(fit), 1e-9).is_reached) state.SkipWithError("a width was not reached");
      }
    }
    state.counters["fits"] = static_cast<double>(fits.size());
  });
  register_proof("verify/published-pair/1e-9", [](benchmark::State& state) {
    const Certificate certificate = certify(published_pair(), 1e-9).certificate;
    for (auto _ : state) {
      if (!reason_to_refuse(certificate).empty()) state.SkipWithError("a certificate was refused");
    }
  });
}

}  // namespace shadefit::bench
