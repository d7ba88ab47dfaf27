#pragma once

#include <functional>
#include <span>
#include <vector>

/// Times many pieces of work for a comparison.
///
/// A machine drifts: its clock rate, its caches, its other guests. So pieces of work are timed in rounds,
/// each of which visits every piece once: a drift affects all. Within a visit, a piece is repeated until the
/// resolution of the clock does not matter.
namespace shadefit::bench {

/// A timed piece of work.
struct Work {
  std::function<double(long repeats)> run;  ///< repeats it so often and returns the seconds
  double elements;                          ///< of one repeat
};

struct TimingPlan {
  int rounds;      ///< each visits every piece of work once
  double seconds;  ///< the least time of a visit
};

/// The times of one piece of work.
struct Samples {
  long repeats = 0;        ///< within a visit
  std::vector<double> ns;  ///< per element, one number per round
};

/// The smallest power of two of repeats that take at least `seconds`; at most `most`. `run` repeats its work
/// so often and returns the seconds. The number is doubled from one on, so no run takes much longer than
/// twice `seconds`, or than one repeat.
long repeats_that_take(double seconds, long most, const std::function<double(long)>& run);

/// Times all of the work; every other round goes backwards. Between visits, `between` gets the finished
/// share, from 0 to 1. It may end the work by throwing.
std::vector<Samples> time_interleaved(std::span<const Work> work, const TimingPlan& plan,
                                      const std::function<void(double)>& between);

}  // namespace shadefit::bench
