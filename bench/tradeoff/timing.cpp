#include "bench/tradeoff/timing.hpp"

#include <cstddef>

namespace shadefit::bench {

long repeats_that_take(double seconds, long most, const std::function<double(long)>& run) {
  for (long repeats = 1;; repeats *= 2)
    if (run(repeats) >= seconds || repeats > most / 2) return repeats;
}

std::vector<Samples> time_interleaved(std::span<const Work> work, const TimingPlan& plan,
                                      const std::function<void(double)>& between) {
  constexpr long most_repeats = 1L << 24;  // no device does so many in a millisecond
  std::vector<Samples> all(work.size());
  // The calibration takes about as long as two rounds.
  const double steps = static_cast<double>(work.size()) * (plan.rounds + 2);
  double done = 0;
  for (std::size_t i = 0; i < work.size(); ++i, done += 2) {
    between(done / steps);
    all[i].repeats = repeats_that_take(plan.seconds, most_repeats, work[i].run);
  }
  for (int round = 0; round < plan.rounds; ++round) {
    for (std::size_t place = 0; place < work.size(); ++place) {
      // Every other round goes backwards, so that the predecessor of a piece varies.
      const std::size_t i = round % 2 == 0 ? place : work.size() - 1 - place;
      between(done++ / steps);
      const double elements = static_cast<double>(all[i].repeats) * work[i].elements;
      all[i].ns.push_back(1e9 * work[i].run(all[i].repeats) / elements);
    }
  }
  between(1);
  return all;
}

}  // namespace shadefit::bench
