#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

/// How long work takes, when many pieces of work are to be compared.
///
/// A machine drifts: its clock rate, its caches, its other guests. So pieces of work are not timed one after
/// the other but in rounds, each of which visits every piece once; what drifts hits all alike. A piece is
/// repeated within a visit for so long that the grain of the clock does not count.
namespace shadefit::bench {

/// A moment, in seconds from whatever the clock counts from.
struct Instant {
  double real;  ///< by a steady clock
  double cpu;   ///< processor time of this thread
};

using Clock = std::function<Instant()>;

/// The steady clock and the thread's processor time.
Instant now();

/// Results that nobody reads are not left out: to the compiler, somebody reads all of the memory here.
inline void keep(const void* memory) {
  asm volatile("" : : "r"(memory) : "memory");
}

/// Something that is timed.
struct Work {
  std::function<void()> once;
  std::size_t elements;  ///< that one call works on
  bool is_warm = true;   ///< is called before each visit, untimed, so that its data are in the cache
};

struct Plan {
  int rounds;      ///< each visits every piece of work once
  double seconds;  ///< that a visit should take at least
};

/// What came of one piece of work.
struct Samples {
  long calls = 0;            ///< within a visit
  std::vector<double> real;  ///< ns per element, a number a round
  std::vector<double> cpu;
};

/// The places of `count` pieces of work in the order in which a round visits them: every other round
/// backwards, so that nobody always comes after the same one.
std::vector<std::size_t> visits(int round, std::size_t count);

/// How many calls take `seconds` at least by that clock: doubled until they do, at most 2^30.
long calls_that_take(const Work& work, double seconds, const Clock& clock);

/// Times all of the work. `between` is told the share that is done, from 0 to 1, between visits; it may end
/// the whole by throwing.
std::vector<Samples> time_interleaved(std::span<const Work> work, const Plan& plan, const Clock& clock,
                                      const std::function<void(double)>& between);

}  // namespace shadefit::bench
