#include "app/output/print.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstddef>

namespace shadefit {

Printed print(int descriptor, std::string_view text, const sigset_t& held) {
  // A pipe that is ready for writing takes this much at once, so no write blocks.
  constexpr std::size_t most_at_once = PIPE_BUF;
  constexpr int between_looks = 100;  // milliseconds in which a signal waits while nobody reads
  while (!text.empty()) {
    if (const int signal = take_signal(held); signal > 0) return {.signal = signal};
    pollfd reader{descriptor, POLLOUT, 0};
    const int ready = ::poll(&reader, 1, between_looks);
    if (ready == 0 || (ready < 0 && errno == EINTR)) continue;  // stopped and continued
    if (ready < 0) return {.error = errno};
    const ssize_t written = ::write(descriptor, text.data(), std::min(text.size(), most_at_once));
    if (written < 0 && errno != EINTR && errno != EAGAIN) return {.error = errno};
    if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

}  // namespace shadefit
