#include "app/interrupt.hpp"

#include <ctime>

namespace shadefit {

HeldSignals hold_interrupts() {
  HeldSignals signals{};
  sigemptyset(&signals.held);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    sigaction(signal, nullptr, &action);
    if (action.sa_handler != SIG_IGN) sigaddset(&signals.held, signal);
  }
  pthread_sigmask(SIG_BLOCK, &signals.held, &signals.mask_before);
  return signals;
}

void release(const HeldSignals& signals) {
  pthread_sigmask(SIG_SETMASK, &signals.mask_before, nullptr);
}

Checkpoint interruptible(const HeldSignals& signals) {
  return [held = signals.held] {
    constexpr std::timespec no_time{};
    const int signal = sigtimedwait(&held, nullptr, &no_time);
    if (signal > 0) throw Interrupted{signal};
  };
}

}  // namespace shadefit
