#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/solver/benchmarks.hpp"
#include "fit/catalogue/family.hpp"
#include "fit/steps/digits.hpp"
#include "fit/support/sweep.hpp"

namespace shadefit::bench {
namespace {

struct Problem {
  const Family* family;
  Setting setting;
  Metric metric;
};

/// A family under each measure, at each exponent of a sweep, else of its own; once per measure if it has no
/// exponent.
std::vector<Problem> problems(std::string_view id, std::span<const Measure> measures,
                              std::string_view sweep = {}) {
  const Family& family = *find_family(id);
  std::vector<Problem> result;
  for (const Measure measure : measures) {
    const Metric metric{.measure = measure};
    if (!family.has_exponent()) {
      result.push_back({&family, {}, metric});
      continue;
    }
    for (const double exponent : parse_sweep(sweep.empty() ? family.sweep : sweep))
      result.push_back({&family, exponent, metric});
  }
  return result;
}

/// One pass over all problems, each from nothing: read, recorded, sampled, fitted, with its largest errors.
/// The counter `digits` shows a fast wrong answer; a fit that did not converge fails the benchmark.
void register_problems(const std::string& name, const std::vector<Problem>& problems) {
  benchmark::RegisterBenchmark(name.c_str(), [problems](benchmark::State& state) {
    int digits = most_digits;  // of the worst
    for (auto _ : state) {
      for (const auto& [family, setting, metric] : problems) {
        const Fit fit = family->fit(setting, metric);
        require(fit.status == Status::converged, "a fit did not converge");
        digits = std::min(digits, fit.digits);
      }
      benchmark::DoNotOptimize(digits);
    }
    const auto fits = static_cast<double>(problems.size());
    state.counters["digits"] = digits;
    state.counters["per_fit"] =
        benchmark::Counter(fits, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
    state.counters["fits"] = fits;
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
  register_problems("fit/fresnel-one-term", problems("fresnel-one-term", cosine));
  register_problems("fit/fresnel-quadratic", problems("fresnel-quadratic", cosine));
  register_problems("fit/sg-offset-3-to-15", problems("sg-offset", cosine, "3:15:1"));
  register_problems("fit/phong-blinn", problems("phong-blinn", cosine));
  std::vector<Problem> catalogue;
  for (const char* id : {"sg-offset", "fresnel-one-term", "fresnel-quadratic", "phong-blinn"})
    for (const Problem& problem : problems(id, measures)) catalogue.push_back(problem);
  register_problems("fit/catalogue", catalogue);
  benchmark::RegisterBenchmark("scaling/sg-offset", fit_on_threads)
      ->ThreadRange(1, 2)
      ->UseRealTime()
      ->Unit(benchmark::kMicrosecond);
  // The pair by its largest error, from nothing: a start by Ceres, the exchange, the polish.
  for (const Error error : {Error::absolute, Error::relative})
    register_problems("minimax/fresnel-quadratic/" + std::string(name(error)),
                      {{find_family("fresnel-quadratic"), {}, {.norm = Norm::minimax, .error = error}}});
}

}  // namespace shadefit::bench
