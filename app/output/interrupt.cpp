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

HeldSignals hold_interrupts() {
  HeldSignals signals{};
  sigemptyset(&signals.held);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    sigaction(signal, nullptr, &action);
    if (action.sa_handler != SIG_IGN) sigaddset(&signals.held, signal);
  }
  pthread_sigmask(SIG_BLOCK, &signals.held, nullptr);
  return signals;
}

void take_waiting(const HeldSignals& signals) {
  while (take_one(signals.held) > 0) {
  }
}

Checkpoint interruptible(const HeldSignals& signals) {
  return [held = signals.held] {
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
