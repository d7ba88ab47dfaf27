#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "bench/solver/benchmarks.hpp"
#include "fit/families/families.hpp"
#include "fit/least_squares/least_squares.hpp"

namespace shadefit::bench {
namespace {

/// Of `count` exponents, evenly on a logarithmic scale within 0.1 .. 1e6, the one in place `i`. Computed on
/// demand: a list would take memory in proportion to `count`.
double exponent(long i, long count) {
  return std::pow(10, -1 + 7 * (static_cast<double>(i) + 0.5) / static_cast<double>(count));
}

/// The kept results of all fits.
struct Reduced {
  double sum = 0;  ///< of the parameters
  int digits = most_digits;
  bool have_all_converged = true;
};

/// Every `stride`-th exponent from `first` on: so that each thread has small and large ones, whose costs
/// differ.
Reduced fit_share(long first, long stride, long count) {
  Reduced reduced;
  for (long i = first; i < count; i += stride) {
    const auto optimum = solve_least_squares(SgOffset{{exponent(i, count)}}, Metric{});
    reduced.sum += optimum.parameters[0];
    reduced.digits = std::min(reduced.digits, optimum.digits);
    reduced.have_all_converged = reduced.have_all_converged && optimum.status == Status::converged;
  }
  return reduced;
}

/// Fits share nothing: each thread has its own exponents.
Reduced fit_all(long count, long threads) {
  std::vector<Reduced> parts(static_cast<std::size_t>(threads));
  std::vector<std::thread> others;
  for (long t = 1; t < threads; ++t) {
    others.emplace_back([&part = parts[static_cast<std::size_t>(t)], t, threads, count] {
      part = fit_share(t, threads, count);
    });
  }
  parts[0] = fit_share(0, threads, count);
  for (std::thread& other : others) other.join();
  Reduced all;
  for (const Reduced& part : parts) {
    all.sum += part.sum;
    all.digits = std::min(all.digits, part.digits);
    all.have_all_converged = all.have_all_converged && part.have_all_converged;
  }
  return all;
}

/// A line of Linux's status of this process, in 10^6 bytes: VmRSS is the current resident set, VmHWM its
/// maximum since the last `forget_peak`. 0 without such a line.
double resident_mb(std::string_view label) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind(label, 0) == 0) return std::stod(line.substr(line.find(':') + 1)) * 1024 / 1e6;
  }
  return 0;
}

void forget_peak() {
  std::ofstream("/proc/self/clear_refs") << 5;
}

void measure(benchmark::State& state) {
  const long count = state.range(0), threads = state.range(1);
  forget_peak();
  const double before = resident_mb("VmRSS");
  Reduced reduced;
  for (auto _ : state) {
    reduced = fit_all(count, threads);
    benchmark::DoNotOptimize(reduced);
  }
  if (!reduced.have_all_converged) state.SkipWithError("a fit did not converge");
  state.counters["digits"] = reduced.digits;
  state.counters["growth_MB"] = std::max(0.0, resident_mb("VmHWM") - before);
  state.counters["peak_MB"] = resident_mb("VmHWM");
  state.counters["per_fit"] =
      benchmark::Counter(static_cast<double>(count),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
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
