#include "bench/tradeoff/timing.hpp"

#include <chrono>

namespace shadefit::bench {
namespace {

/// The seconds of so many calls.
double seconds_of(const Work& work, long calls, const Clock& clock) {
  const double before = clock();
  for (long i = 0; i < calls; ++i) work.once();
  return clock() - before;
}

/// One visit: a few warm calls, then the timed ones.
void sample(const Work& work, Samples& samples, const Clock& clock) {
  // An eighth of a visit restores caches and branch prediction.
  for (long i = 0; work.is_warm && i < samples.calls / 8 + 1; ++i) work.once();
  const double to_ns = 1e9 / (static_cast<double>(samples.calls) * static_cast<double>(work.elements));
  samples.ns.push_back(seconds_of(work, samples.calls, clock) * to_ns);
}

}  // namespace

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

long repeats_that_take(double seconds, long most, const std::function<double(long)>& run) {
  for (long repeats = 1;; repeats *= 2)
    if (run(repeats) >= seconds || repeats > most / 2) return repeats;
}

std::vector<Samples> time_interleaved(std::span<const Work> work, const TimingPlan& plan, const Clock& clock,
                                      const std::function<void(double)>& between) {
  std::vector<Samples> all(work.size());
  // The calibration takes about as long as two rounds.
  const double steps = static_cast<double>(work.size()) * (plan.rounds + 2);
  double done = 0;
  for (std::size_t i = 0; i < work.size(); ++i, done += 2) {
    between(done / steps);
    all[i].calls = repeats_that_take(plan.seconds, 1L << 30,
                                     [&](long calls) { return seconds_of(work[i], calls, clock); });
  }
  for (int round = 0; round < plan.rounds; ++round) {
    for (std::size_t place = 0; place < work.size(); ++place) {
      // Every other round goes backwards, so that the predecessor of a piece varies.
      const std::size_t i = round % 2 == 0 ? place : work.size() - 1 - place;
      between(done++ / steps);
      sample(work[i], all[i], clock);
    }
  }
  between(1);
  return all;
}

}  // namespace shadefit::bench
