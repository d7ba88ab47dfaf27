#include "app/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace shadefit {

Progress terminal_progress(int descriptor) {
  if (::isatty(descriptor) == 0) return unwatched;
  using Clock = std::chrono::steady_clock;
  // Ten lines a second are as many as anybody reads.
  static constexpr std::chrono::milliseconds shortest{100};
  return [descriptor, last = Clock::time_point(), is_shown = false](const std::string& line) mutable {
    const auto now = Clock::now();
    const bool is_due = line.empty() ? is_shown : now - last >= shortest;
    if (!is_due) return;
    // Back to the first column, and what stands from there on erased.
    const std::string text = "\r\x1b[K" + line;
    const auto written = ::write(descriptor, text.data(), text.size());
    is_shown = written > 0 && !line.empty();
    last = now;
  };
}

std::string progress_line(const std::string& what, double share, double seconds) {
  constexpr int width = 30;
  const int full = static_cast<int>(std::clamp(share, 0.0, 1.0) * width);
  std::string line =
      fmt::format("{} [{}{}] {:.0f} %", what, std::string(static_cast<std::size_t>(full), '#'),
                  std::string(static_cast<std::size_t>(width - full), '.'), std::floor(share * 100));
  constexpr double least_to_go_by = 0.01;
  if (share >= least_to_go_by)
    line += fmt::format(", {:.0f} s left", std::ceil(seconds * (1 - share) / share));
  return line;
}

}  // namespace shadefit
