#include "app/output/interrupt.hpp"

#include <chrono>
#include <ctime>

namespace shadefit {

namespace {

/// Takes a pending signal; returns a number <= 0 if none is pending.
int take_one(const sigset_t& held) {
  constexpr std::timespec no_time{};
  return sigtimedwait(&held, nullptr, &no_time);
}

}  // namespace

sigset_t hold_interrupts() {
  sigset_t held{};
  sigemptyset(&held);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    sigaction(signal, nullptr, &action);
    if (action.sa_handler != SIG_IGN) sigaddset(&held, signal);
  }
  pthread_sigmask(SIG_BLOCK, &held, nullptr);
  return held;
}

void take_waiting(const sigset_t& held) {
  while (take_one(held) > 0) {
  }
}

Checkpoint interruptible(const sigset_t& held) {
  return [held] {
    const int signal = take_one(held);
    if (signal > 0) throw Interrupted{signal};
  };
}

Checkpoint limited(const Checkpoint& checkpoint, double seconds) {
  using Clock = std::chrono::steady_clock;
  return [checkpoint, seconds, start = Clock::now()] {
    checkpoint();
    if (std::chrono::duration<double>(Clock::now() - start).count() > seconds) throw TimeIsOver{seconds};
  };
}

}  // namespace shadefit
