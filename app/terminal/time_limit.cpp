#include "app/terminal/time_limit.hpp"

#include <fmt/format.h>

#include <chrono>

#include "fit/support/user_error.hpp"

namespace shadefit {

Checkpoint limited(const Checkpoint& checkpoint, double seconds) {
  using Clock = std::chrono::steady_clock;
  return [checkpoint, seconds, start = Clock::now()] {
    checkpoint();
    if (std::chrono::duration<double>(Clock::now() - start).count() > seconds)
      throw CheckFailed(fmt::format("stopped: the --time-limit of {} seconds is over", seconds));
  };
}

}  // namespace shadefit
