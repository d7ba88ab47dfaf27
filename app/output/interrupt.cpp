#include "app/output/interrupt.hpp"

#include <chrono>
#include <ctime>

namespace shadefit {

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

int take_signal(const sigset_t& held) {
  constexpr std::timespec no_time{};
  return sigtimedwait(&held, nullptr, &no_time);
}

Checkpoint interruptible(const sigset_t& held) {
  return [held] {
    const int signal = take_signal(held);
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
