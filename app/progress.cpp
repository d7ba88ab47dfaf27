#include "app/progress.hpp"

#include <unistd.h>

#include <cstdio>
#include <string>

namespace shadefit {

Progress terminal_progress() {
  if (isatty(STDERR_FILENO) == 0) return in_silence;
  return [](std::string_view part) {
    // Back to the first column, and erase to the end of the line.
    const std::string line = "\r\x1b[K" + std::string(part);
    std::fwrite(line.data(), 1, line.size(), stderr);
    std::fflush(stderr);
  };
}

}  // namespace shadefit
