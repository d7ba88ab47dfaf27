#include "app/terminal/time_limit.hpp"

#include <chrono>

namespace shadefit {

Checkpoint limited(const Checkpoint& checkpoint, double seconds) {
  using Clock = std::chrono::steady_clock;
  return [checkpoint, seconds, start = Clock::now()] {
    checkpoint();
    if (std::chrono::duration<double>(Clock::now() - start).count() > seconds) throw TimeIsOver{seconds};
  };
}

}  // namespace shadefit
