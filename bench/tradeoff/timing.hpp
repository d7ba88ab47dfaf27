#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

/// Times many pieces of work for a comparison.
///
/// A machine drifts: its clock rate, its caches, its other guests. So pieces of work are timed in rounds,
/// each of which visits every piece once: a drift affects all. Within a visit, a piece is repeated until the
/// resolution of the clock does not matter.
namespace shadefit::bench {

/// Seconds since the clock's origin.
using Clock = std::function<double()>;

/// The steady clock.
double now();

/// Keeps the compiler from removing unused results: for the compiler, this reads all of the memory.
inline void keep(const void* memory) {
  asm volatile("" : : "r"(memory) : "memory");
}

/// A timed piece of work.
struct Work {
  std::function<void()> once;
  std::size_t elements;  ///< of one call
  bool is_warm = true;   ///< each visit begins with untimed calls, so that its data are in the cache
};

struct TimingPlan {
  int rounds;      ///< each visits every piece of work once
  double seconds;  ///< the least time of a visit
};

/// The times of one piece of work.
struct Samples {
  long calls = 0;          ///< within a visit
  std::vector<double> ns;  ///< per element, one number per round
};

/// The smallest power of two of repeats that take at least `seconds`; at most `most`. `run` repeats its work
/// so often and returns the seconds. The number is doubled from one on, so no run takes much longer than
/// twice `seconds`, or than one repeat.
long repeats_that_take(double seconds, long most, const std::function<double(long)>& run);

/// Times all of the work; every other round goes backwards. Between visits, `between` gets the finished
/// share, from 0 to 1. It may end the work by throwing.
std::vector<Samples> time_interleaved(std::span<const Work> work, const TimingPlan& plan, const Clock& clock,
                                      const std::function<void(double)>& between);

}  // namespace shadefit::bench
