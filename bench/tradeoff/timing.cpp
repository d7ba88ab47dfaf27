#include "bench/tradeoff/timing.hpp"

#include <chrono>

namespace shadefit::bench {
namespace {

/// One visit: a few warm calls, then the timed ones.
void sample(const Work& work, Samples& samples, const Clock& clock) {
  // An eighth of a visit restores caches and branch prediction.
  for (long i = 0; work.is_warm && i < samples.calls / 8 + 1; ++i) work.once();
  const double before = clock();
  for (long i = 0; i < samples.calls; ++i) work.once();
  const double to_ns = 1e9 / (static_cast<double>(samples.calls) * static_cast<double>(work.elements));
  samples.ns.push_back((clock() - before) * to_ns);
}

}  // namespace

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

long calls_that_take(const Work& work, double seconds, const Clock& clock) {
  constexpr long most = 1L << 30;
  for (long calls = 1;; calls *= 2) {
    const double before = clock();
    for (long i = 0; i < calls; ++i) work.once();
    if (clock() - before >= seconds || calls >= most) return calls;
  }
}

std::vector<Samples> time_interleaved(std::span<const Work> work, const TimingPlan& plan, const Clock& clock,
                                      const std::function<void(double)>& between) {
  std::vector<Samples> all(work.size());
  // The calibration takes about as long as two rounds.
  const double steps = static_cast<double>(work.size()) * (plan.rounds + 2);
  double done = 0;
  for (std::size_t i = 0; i < work.size(); ++i, done += 2) {
    between(done / steps);
    all[i].calls = calls_that_take(work[i], plan.seconds, clock);
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
