#include "app/output/print.hpp"

#include <poll.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>

namespace shadefit {
namespace {

/// The signals as a readable descriptor. So one poll waits for a reader and for a signal, without a gap in
/// which a signal could be lost.
class SignalDescriptor {
 public:
  explicit SignalDescriptor(const sigset_t& held)
      : descriptor_(::signalfd(-1, &held, SFD_NONBLOCK | SFD_CLOEXEC)) {}
  ~SignalDescriptor() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  SignalDescriptor(const SignalDescriptor&) = delete;
  SignalDescriptor& operator=(const SignalDescriptor&) = delete;

  int get() const { return descriptor_; }  ///< -1, which poll ignores, if no more descriptors are available
  int taken() const {
    signalfd_siginfo info{};
    return ::read(descriptor_, &info, sizeof info) == sizeof info ? static_cast<int>(info.ssi_signo) : 0;
  }

 private:
  int descriptor_;
};

}  // namespace

Printed print(int descriptor, std::string_view text, const sigset_t& held) {
  // A pipe that is ready for writing takes this much at once, so no write blocks.
  constexpr std::size_t most_at_once = PIPE_BUF;
  const SignalDescriptor signal(held);
  while (!text.empty()) {
    std::array<pollfd, 2> ready{pollfd{descriptor, POLLOUT, 0}, pollfd{signal.get(), POLLIN, 0}};
    if (::poll(ready.data(), ready.size(), -1) < 0) {
      if (errno == EINTR) continue;  // stopped and continued
      return {.error = errno};
    }
    if (ready[1].revents != 0) return {.signal = signal.taken()};
    const ssize_t written = ::write(descriptor, text.data(), std::min(text.size(), most_at_once));
    if (written < 0 && errno != EINTR && errno != EAGAIN) return {.error = errno};
    if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

}  // namespace shadefit
