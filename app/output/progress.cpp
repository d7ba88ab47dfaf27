#include "app/output/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <memory>

namespace shadefit {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

Progress terminal_progress(int descriptor, std::chrono::milliseconds patience) {
  if (::isatty(descriptor) == 0) return unwatched;
  // Nobody reads more than ten lines a second.
  static constexpr std::chrono::milliseconds shortest{100};
  return [descriptor, next = Clock::now() + patience, is_shown = false](const std::string& line) mutable {
    const auto now = Clock::now();
    const bool is_due = line.empty() ? is_shown : now >= next;
    if (!is_due) return;
    // Moves to the first column and erases the rest of the line.
    const std::string text = "\r\x1b[K" + line;
    const auto written = ::write(descriptor, text.data(), text.size());
    is_shown = written > 0 && !line.empty();
    next = now + shortest;
  };
}

Watched watch(const Checkpoint& checkpoint, const Progress& progress, const std::string& what) {
  const auto has_own_line = std::make_shared<bool>(false);  // shared by both functions, which may be copied
  return {[&checkpoint, &progress, what, has_own_line, start = Clock::now()] {
            checkpoint();
            if (!*has_own_line) progress(fmt::format("{} .. {:.0f} s", what, seconds_since(start)));
          },
          [&progress, has_own_line](const std::string& line) {
            *has_own_line = !line.empty();
            progress(line);
          }};
}

std::function<void(double share)> bar(const Watched& work, const std::string& what) {
  return [&work, what, start = Clock::now()](double share) {
    work.checkpoint();
    work.progress(progress_line(what, share, seconds_since(start)));
  };
}

Checkpoint stepping(const Watched& work, const std::string& what, std::size_t steps) {
  if (steps < 2) return work.checkpoint;
  return [show = bar(work, what), steps, done = 0.0]() mutable { show(done++ / static_cast<double>(steps)); };
}

std::string progress_line(const std::string& what, double share, double seconds) {
  std::string line = fmt::format("{} {:.0f} %", what, std::floor(share * 100));
  constexpr double least_to_go_by = 0.01;
  if (share >= least_to_go_by)
    line += fmt::format(", {:.0f} s left", std::ceil(seconds * (1 - share) / share));
  return line;
}

}  // namespace shadefit
